/* runs.c - where the files of a run are; see runs.h */
#define _XOPEN_SOURCE 700
#include "runs.h"
#include "uses.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static char *path(const char *folder, const char *prefix, const char *name)
{
  struct text t = TEXT_NONE;

  text_add(&t, "%s/%s%s", folder, prefix, name);
  return t.at;
}

static int is_kind(const char *file, mode_t kind)
{
  struct stat about;

  return stat(file, &about) == 0 && (about.st_mode & S_IFMT) == kind;
}

static char *if_there(char *file)
{
  if (is_kind(file, S_IFREG))
    return file;
  free(file);
  return NULL;
}

static void find_layout(const char *folder, struct run_files *files)
{
  char *origin = path(folder, "", "origin");
  struct text text = TEXT_NONE, why = TEXT_NONE;

  if (read_file(origin, &text, &why) == 0) {
    char *layout = strncmp(text.at, "layout=", 7) == 0 ? text.at : strstr(text.at, "\nlayout=");

    if (layout) {
      layout = strchr(layout, '=') + 1;
      layout[strcspn(layout, "\n")] = '\0';
      files->layout = path("", "", layout);
      memmove(files->layout, files->layout + 1, strlen(files->layout)); /* the slash */
    }
  }
  text_free(&text);
  text_free(&why);
  free(origin);
}

/* The only name behind b. in a folder; NULL for none or several. */
static char *only_name(const char *folder)
{
  DIR *d = opendir(folder);
  struct text name = TEXT_NONE;
  struct dirent *entry;
  int n = 0;

  while (d && (entry = readdir(d)))
    if (strncmp(entry->d_name, "b.", 2) == 0 && entry->d_name[2]) {
      n++;
      text_clear(&name);
      text_add(&name, "%s", entry->d_name + 2);
    }
  if (d)
    closedir(d);
  if (n != 1)
    text_free(&name);
  return name.at;
}

/* Whether a word without a slash is a file of AUTO's in this folder. */
static int is_file_here(const char *word)
{
  return (strncmp(word, "b.", 2) == 0 || strcmp(word, "fort.7") == 0) && is_kind(word, S_IFREG);
}

/* A folder and the name behind b. there. */
static void split(const char *word, struct text *folder, struct text *name)
{
  const char *slash = strrchr(word, '/');
  const size_t length = strlen(word);

  if (slash && is_kind(word, S_IFREG)) { /* a file by its own name */
    text_append(folder, word, (size_t)(slash - word));
    text_add(name, "%s", strncmp(slash + 1, "b.", 2) == 0 ? slash + 3 : slash + 1);
  } else if (!slash && is_file_here(word)) {
    text_add(folder, ".");
    text_add(name, "%s", strncmp(word, "b.", 2) == 0 ? word + 2 : word);
  } else if (slash && is_kind(word, S_IFDIR)) {
    char *only = only_name(word);

    text_add(folder, "%s", word);
    text_add(name, "%s", only ? only : "fort.7");
    free(only);
  } else if (slash) {
    text_append(folder, word, (size_t)(slash - word));
    text_add(name, "%s", slash + 1);
  } else {
    text_add(folder, "%s/%s", runs_folder(), word);
    text_append(name, word, length > 5 && strcmp(word + length - 5, ".part") == 0 ? length - 5 : length);
  }
  if (folder->length == 0)
    text_add(folder, "%s", word[0] == '/' ? "/" : ".");
}

int find_run(const char *word, struct run_files *files, struct text *why)
{
  struct text folder = TEXT_NONE, name = TEXT_NONE;
  int status = 0;

  *files = (struct run_files){ 0 };
  if (!strchr(word, '/') && !is_file_here(word) && !is_name(word)) {
    text_add(why, "'%s' is no name of a run: %s", word, NAME_RULE);
    return -1;
  }
  split(word, &folder, &name);
  if (strcmp(name.at, "fort.7") == 0) {
    files->b = path(folder.at, "", "fort.7");
    files->d = if_there(path(folder.at, "", "fort.9"));
    files->s = if_there(path(folder.at, "", "fort.8"));
  } else {
    files->b = path(folder.at, "b.", name.at);
    files->d = if_there(path(folder.at, "d.", name.at));
    files->s = if_there(path(folder.at, "s.", name.at));
  }
  files->log = if_there(path(folder.at, "", "auto.log"));
  find_layout(folder.at, files);
  files->name = path("", "", name.at);
  memmove(files->name, files->name + 1, strlen(files->name)); /* the slash */
  if (!is_kind(files->b, S_IFREG)) {
    text_add(why, "there is no run '%s', no %s", word, files->b);
    free_run(files);
    status = -1;
  } else {
    note_use(files->b);
    note_use(files->d);
    note_use(files->s);
  }
  text_free(&folder);
  text_free(&name);
  return status;
}

void free_run(struct run_files *files)
{
  free(files->name);
  free(files->b);
  free(files->d);
  free(files->s);
  free(files->log);
  free(files->layout);
  *files = (struct run_files){ 0 };
}

int find_run_or_say(const char *command, const char *word, struct run_files *files)
{
  struct text why = TEXT_NONE;

  if (find_run(word, files, &why) == 0)
    return 0;
  say_line(command, why.at);
  text_free(&why);
  return 2;
}
