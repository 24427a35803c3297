/* embed.c - mlg embed: a page of HTML that needs nothing beside it */
#include <ctype.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "text.h"
#include "uses.h"

static void add_base64(struct text *page, const struct text *bytes)
{
  static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  char four[4];

  for (size_t i = 0; i < bytes->length; i += 3) {
    const size_t left = bytes->length - i;
    const unsigned char *t = (const unsigned char *)bytes->at + i;
    const unsigned long three = (unsigned long)t[0] << 16 | (left > 1 ? (unsigned long)t[1] << 8 : 0) | (left > 2 ? t[2] : 0);

    for (int k = 0; k < 4; k++)
      four[k] = digit[three >> (18 - 6 * k) & 63];
    if (left < 3)
      four[3] = '=';
    if (left < 2)
      four[2] = '=';
    text_append(page, four, 4);
  }
}

static int is_readable(const struct text *file)
{
  return access(file->at, R_OK) == 0;
}

/* FOLDER/NAME as an address that holds it; of a NAME.png NAME.svg where there is one, for
 * it is sharper and smaller. */
static int add_picture(struct text *page, const char *folder, const char *name, size_t length, struct text *why)
{
  struct text file = TEXT_NONE, svg = TEXT_NONE, bytes = TEXT_NONE;
  const char *type;
  int status;

  text_add(&file, "%s/%.*s", folder, (int)length, name);
  if (file.length > 4 && strcmp(file.at + file.length - 4, ".png") == 0) {
    text_add(&svg, "%.*s.svg", (int)file.length - 4, file.at);
    if (is_readable(&svg)) {
      text_clear(&file);
      text_add(&file, "%s", svg.at);
    }
  }
  note_use(file.at);
  status = read_file(file.at, &bytes, why);
  type = file.at + file.length - 3;
  text_add(page, "data:image/%s;base64,", strcmp(type, "svg") == 0 ? "svg+xml" : type);
  if (status == 0)
    add_base64(page, &bytes);
  text_free(&file);
  text_free(&svg);
  text_free(&bytes);
  return status;
}

/* <h2>Text</h2> with the name that code-hosting pages give to it. */
static void add_heading(struct text *page, const char *line, size_t length)
{
  struct text name = TEXT_NONE;

  text_clear(&name);
  for (size_t i = 0; i < length; i++) {
    const char c = (char)tolower((unsigned char)line[i]);

    if (c == '<' || c == '&')
      i += strcspn(line + i, c == '<' ? ">" : ";");
    else if (isalnum((unsigned char)c) || c == '_' || c == '-' || c == ' ')
      text_append(&name, c == ' ' ? "-" : &c, 1);
  }
  text_add(page, "%.3s id=\"%s\"", line, name.at);
  text_append(page, line + 3, length - 3);
  text_free(&name);
}

static int embed(const char *html, const char *folder, struct text *page, struct text *why)
{
  static const char image[] = "<img src=\"";

  for (const char *t = html, *next; *t; t = next) {
    const size_t length = strcspn(t, "\n") + (t[strcspn(t, "\n")] == '\n');
    const char *from = strstr(t, image);

    next = t + length;
    if (strncmp(t, "<h2>", 4) == 0 || strncmp(t, "<h3>", 4) == 0)
      add_heading(page, t, length);
    else {
      for (; from && from < next; from = strstr(t, image)) {
        const size_t name = strcspn(from + strlen(image), "\"");

        text_append(page, t, (size_t)(from - t) + strlen(image));
        if (add_picture(page, folder, from + strlen(image), name, why) != 0)
          return -1;
        t = from + strlen(image) + name;
      }
      text_append(page, t, (size_t)(next - t));
    }
  }
  return 0;
}

static int run(int argc, char *argv[])
{
  struct text html = TEXT_NONE, page = TEXT_NONE, why = TEXT_NONE;
  char some[4096];
  size_t n;
  int status;

  if (argc != 2) {
    fputs("usage: mlg embed FOLDER < HTML\n", stderr);
    return MLG_BAD_INPUT;
  }
  text_clear(&html);
  while ((n = fread(some, 1, sizeof some, stdin)) > 0)
    text_append(&html, some, n);
  status = embed(html.at, argv[1], &page, &why);
  if (status == 0)
    fwrite(page.at, 1, page.length, stdout);
  else
    say_line("embed", why.at);
  text_free(&html);
  text_free(&page);
  text_free(&why);
  if (status == 0 && fflush(stdout) != 0) {
    perror("embed");
    status = -1;
  }
  return status == 0 ? MLG_OK : MLG_FAILED;
}

const struct command command_embed = {
  "embed", "FOLDER < HTML",
  "a page of HTML with its pictures in it",
  "Copies a page from standard input to standard output, with each picture put in as data, read from\n"
  "FOLDER (of NAME.png NAME.svg where there is one), and headings of the second and third rank named.\n",
  run,
};
