/* select.c - points of runs chosen, and their columns as cells; see select.h */
#include "select.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mlg.h"
#include "branch.h"

int read_run_or_say(const char *command, const char *word, struct run_data *data)
{
  struct text why = TEXT_NONE;

  *data = (struct run_data){ 0 };
  if (find_run_or_say(command, word, &data->files) != 0)
    return 2;
  if (af_read(&data->all, data->files.b, data->files.d, &why) != 0) {
    say_line(command, why.at);
    text_free(&why);
    free_run(&data->files);
    return 2;
  }
  data->ending = must_allocate((size_t)(data->all.parts + 1) * sizeof *data->ending);
  for (int i = 0; i < data->all.parts; i++)
    data->ending[i] = find_ending(&data->all.part[i], data->files.s, data->files.layout);
  data->inertia = must_allocate(sizeof *data->inertia);
  *data->inertia = (struct inertia){ 0 };
  return 0;
}

void free_run_data(struct run_data *data)
{
  free(data->ending);
  free(data->inertia);
  data->ending = NULL;
  data->inertia = NULL;
  af_free(&data->all);
  free_run(&data->files);
}

int read_columns(const char *list, struct columns *columns, struct text *why)
{
  *columns = (struct columns){ NULL, 0 };
  for (const char *t = list; *t;) {
    const size_t length = strcspn(t, ","), name = strcspn(t, ",:");
    struct column *c;

    columns->column = must_resize(columns->column, (size_t)(columns->n + 1) * sizeof *columns->column);
    c = &columns->column[columns->n];
    if (name == 0 || name >= sizeof c->name || length - name > sizeof c->format - 2) {
      text_add(why, "columns: '%.*s': expected NAME or NAME:FORMAT", (int)length, t);
      return -1;
    }
    memcpy(c->name, t, name);
    c->name[name] = '\0';
    strcpy(c->format, "%.6g");
    if (name < length) { /* .8g, .5f, .3e */
      const char *f = t + name + 1, *end = t + length;

      memcpy(c->format + 1, f, (size_t)(end - f));
      c->format[1 + (end - f)] = '\0';
      if (*f == '.')
        for (f++; f < end && isdigit((unsigned char)*f) && f - t < 64; f++)
          ;
      if (f + 1 != end || !strchr("gefd", *f)) {
        text_add(why, "columns: '%.*s': FORMAT is .8g, .5f, .3e or d", (int)length, t);
        return -1;
      }
      if (*f == 'd')
        strcpy(c->format, "%.0f");
    }
    columns->n++;
    t += length + (t[length] == ',');
  }
  if (columns->n > 0)
    return 0;
  text_add(why, "columns=NAME,... says which");
  return -1;
}

void free_columns(struct columns *columns)
{
  free(columns->column);
  *columns = (struct columns){ NULL, 0 };
}

int read_condition(struct choice *choice, const char *text, struct text *why)
{
  const size_t name = strcspn(text, "<>=");
  struct condition *c = &choice->where[choice->conditions];

  if (choice->conditions == (int)(sizeof choice->where / sizeof *choice->where) || name == 0 || name >= sizeof c->name
      || !text[name] || !af_number(text + name + 1, strlen(text + name + 1), &c->value) || isnan(c->value)) {
    text_add(why, "where='%s': expected NAME<VALUE, NAME>VALUE or NAME=VALUE", text);
    return -1;
  }
  memcpy(c->name, text, name);
  c->name[name] = '\0';
  c->relation = text[name];
  choice->conditions++;
  return 0;
}

int lists(const char *list, const char *type)
{
  char word[16];

  if (!*type)
    return 0;
  snprintf(word, sizeof word, ",%s,", type);
  return strstr(list, word) != NULL || strcmp(list, ",any,") == 0;
}

static double largest_size(const struct af_part *part)
{
  const int size = size_column(part);
  double largest = 0.;

  for (long i = 0; i < part->points; i++)
    largest = fmax(largest, af_value(part, i, size));
  return largest;
}

/* Straight rolling has no amplitude, whether its run reports one or not. */
static int is_zero(const struct af_part *part, const char *name)
{
  return is_straight(part) && (strcmp(name, "psi_max") == 0 || strcmp(name, "dstar_max") == 0);
}

int has_column(const struct af_part *part, const char *name)
{
  if (af_column(part, name) >= 0 || strcmp(name, "point") == 0 || strcmp(name, "label") == 0 || is_zero(part, name))
    return 1;
  if (strcmp(name, "frequency") == 0)
    return af_column(part, "period") >= 0;
  if (strcmp(name, "k_s") == 0)
    return af_column(part, "compliance") >= 0;
  return strcmp(name, "size") == 0 && size_column(part) >= 0;
}

double number_at(const struct run_data *data, int part, long point, const char *name)
{
  const struct af_part *p = &data->all.part[part];
  const int column = af_column(p, name);

  if (column >= 0)
    return af_value(p, point, column);
  if (strcmp(name, "frequency") == 0)
    return 1. / af_value(p, point, af_column(p, "period"));
  if (strcmp(name, "k_s") == 0)
    return 1e5 / af_value(p, point, af_column(p, "compliance"));
  if (strcmp(name, "size") == 0)
    return af_value(p, point, size_column(p)) / largest_size(p);
  if (strcmp(name, "point") == 0)
    return (double)p->point[point].number;
  if (strcmp(name, "label") == 0)
    return p->point[point].label;
  return is_zero(p, name) ? 0. : (double)NAN;
}

int is_chosen(const struct choice *choice, const struct run_data *data, int part, long point)
{
  if (choice->only && !lists(choice->only, point_type(&data->all, &data->all.part[part], point)))
    return 0;
  for (int i = 0; i < choice->conditions; i++) {
    const struct condition *c = &choice->where[i];
    const double x = number_at(data, part, point, c->name);

    if (!(c->relation == '<' ? x < c->value : c->relation == '>' ? x > c->value : fabs(x - c->value) <= 1e-6 * fabs(c->value) + 1e-12))
      return 0;
  }
  return 1;
}

const char *shown_type(const struct choice *choice, const struct run_data *data, int part, long point)
{
  const struct af_part *p = &data->all.part[part];
  const char *type;

  if (point >= data->ending[part].kept || (choice->ends && point == 0 && is_orbits(p)))
    return "HB";
  type = point_type(&data->all, p, point);
  return lists(choice->types, type) ? type : "";
}

const char *paper_name(const struct run_data *data, int part, long point, int i)
{
  static const char *const wanted[] = { "ratio", "kind", "f", "c" };
  double value[4];

  for (int k = 0; k < 4; k++) {
    char name[32];

    snprintf(name, sizeof name, "%s_%d", wanted[k], i);
    value[k] = number_at(data, part, point, name);
  }
  const int delta = value[0] > 1., low = value[1] > 0.;

  if (delta)
    return low ? "BP2_l" : "BP2_u";
  if (value[3] > 5e4)
    return "-";
  if (low)
    return value[2] < 12. ? "BP3" : "-";
  return value[2] < 9. ? "BP1" : "psi3";
}

/* Of a run along k_s also where a region is born and where two meet. */
static const char *name_along(const struct run_data *data, int part, long point)
{
  if (strcmp(point_type(&data->all, &data->all.part[part], point), "LP") == 0)
    return number_at(data, part, point, "ratio_1") > 1. ? "onset" : "meet";
  return paper_name(data, part, point, 1);
}

/* Which of its type, by IRS, a labelled point is; 0 for none. */
static int times_seen(const struct run_data *data, int part, long point)
{
  const struct af_part *p = &data->all.part[part];
  const char *type = af_type_name(p->point[point].type);
  int n = 0;

  if (p->point[point].label == 0 || !*type)
    return 0;
  for (int k = 0; k <= part; k++)
    for (long i = 0; i < data->all.part[k].points && !(k == part && i > point); i++)
      n += data->all.part[k].point[i].label > 0 && strcmp(af_type_name(data->all.part[k].point[i].type), type) == 0;
  return n;
}

/* Cells that are no number; 1 when the column is one of them. */
static int add_word(struct text *row, const struct choice *choice, const struct run_data *data, int part, long point, const char *name,
                    int number, struct text *why)
{
  const struct af_part *p = &data->all.part[part];
  const int closing = point >= data->ending[part].kept, boundary = af_column(p, "kind_1") >= 0 && af_column(p, "ratio_1") >= 0;
  const long at = closing ? data->ending[part].kept - 1 : point;

  if (strcmp(name, "type") == 0)
    text_add(row, "%s", shown_type(choice, data, part, point));
  else if (strcmp(name, "stable") == 0) {
    const int stable = closing || (choice->bifurcations_stable && *shown_type(choice, data, part, point)) ? 1 : point_stability(&data->all, p, point);

    text_add(row, "%s", stable < 0 ? "" : stable ? "1" : "0");
  } else if (strcmp(name, "run") == 0)
    text_add(row, "%s", data->files.name);
  else if (strcmp(name, "number") == 0)
    text_add(row, "%d", number);
  else if (strcmp(name, "name") == 0) {
    if (!closing && times_seen(data, part, point))
      text_add(row, "%s%d", af_type_name(p->point[point].type), times_seen(data, part, point));
  } else if (strcmp(name, "label") == 0) {
    if (!closing && p->point[point].label > 0)
      text_add(row, "%d", p->point[point].label);
  } else if (strcmp(name, "shimmy") == 0) {
    const char *of = shimmy_at(data, part, at, why);

    text_add(row, "%s", of ? of : "");
  } else if (strcmp(name, "extremum") == 0 && boundary)
    text_add(row, "%s", af_value(p, point, af_column(p, "kind_1")) > 0. ? "min" : "max");
  else if (strcmp(name, "bp") == 0 && boundary && af_column(p, "c_1") >= 0 && af_column(p, "f_1") >= 0)
    text_add(row, "%s", name_along(data, part, point));
  else if (strcmp(name, "curve") == 0) {
    const char *from = data->files.name;

    for (const char *t = from; (t = strstr(t, ".b")); t += 2) {
      const size_t digits = strspn(t + 2, "0123456789");

      if (digits > 0 && t[2 + digits] == '.')
        from = t + 3 + digits;
    }
    text_add(row, "%s", from);
  } else
    return 0;
  return 1;
}

/* The closing Hopf point has the parameters of the last orbit, and no size. */
static double closing_value(const struct run_data *data, int part, const char *name)
{
  const struct af_part *p = &data->all.part[part];
  const struct ending *e = &data->ending[part];

  if (strcmp(name, p->column[0]) == 0)
    return e->value;
  if (strcmp(name, "period") == 0)
    return e->period;
  if (strcmp(name, "frequency") == 0)
    return 1. / e->period;
  return mlg_find(name, strlen(name)) ? number_at(data, part, e->kept - 1, name) : 0.;
}

int add_cell(struct text *row, const struct choice *choice, const struct run_data *data, int part, long point, const struct column *column,
             int number, struct text *why)
{
  const struct af_part *p = &data->all.part[part];
  double x;

  if (add_word(row, choice, data, part, point, column->name, number, why))
    return why->length > 0 ? -1 : 0;
  if (!has_column(p, column->name)) {
    text_add(why, "%s has no column '%s'; it has", data->files.b, column->name);
    for (int k = 0; k < p->columns; k++)
      text_add(why, "%s %s", k ? "," : "", p->column[k]);
    return -1;
  }
  x = point >= data->ending[part].kept ? closing_value(data, part, column->name) : number_at(data, part, point, column->name);
  /* rigid: AUTO's number for it, or a compliance of 0 to AUTO's precision */
  if (strcmp(column->name, "k_s") == 0 && !(x > 0. && x < (af_column(p, "k_s") < 0 ? 1e13 : MLG_RIGID)))
    text_add(row, "inf");
  else
    text_add(row, column->format, x);
  return 0;
}
