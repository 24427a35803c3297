/* autonumber.c - numbers as Fortran writes them, and AUTO's types of points; see autofile.h */
#include "autofile.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Digits with a point and an exponent of AUTO's length, exactly: a whole number below
 * 2^53 times or by a power of ten up to 10^22 is rounded once.  0 for anything else. */
static int plain_number(const char *t, const char *end, double *value)
{
  static const double power[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
  const int negative = *t == '-';
  int digits = 0, behind = 0, point = 0, exponent = 0, sign = 1;
  uint64_t whole = 0;

  for (t += *t == '-' || *t == '+'; t < end && (isdigit((unsigned char)*t) || (*t == '.' && !point)); t++) {
    if (*t == '.')
      point = 1;
    else {
      whole = 10 * whole + (uint64_t)(*t - '0');
      digits++;
      behind += point;
    }
  }
  if (digits == 0 || digits > 15)
    return 0;
  if (t < end) {
    const char *first;

    if (*t != 'E' && *t != 'e')
      return 0;
    t++;
    if (t < end && (*t == '-' || *t == '+'))
      sign = *t++ == '-' ? -1 : 1;
    for (first = t; t < end && isdigit((unsigned char)*t) && t - first < 4; t++)
      exponent = 10 * exponent + (*t - '0');
    if (t == first || t < end)
      return 0;
  }
  exponent = sign * exponent - behind;
  if (whole == 0)
    *value = 0.;
  else if (exponent >= 0 && exponent <= 22)
    *value = (double)whole * power[exponent];
  else if (exponent < 0 && exponent >= -22)
    *value = (double)whole / power[-exponent];
  else
    return 0;
  if (negative)
    *value = -*value;
  return 1;
}

int af_number(const char *text, size_t length, double *value)
{
  char copy[64];
  size_t n = 0;
  char *end;

  while (length > 0 && isspace((unsigned char)*text))
    text++, length--;
  while (length > 0 && isspace((unsigned char)text[length - 1]))
    length--;
  if (length > 0 && plain_number(text, text + length, value))
    return 1;
  if (length == 0 || length >= sizeof copy - 2 || memchr(text, 'x', length) || memchr(text, 'X', length))
    return 0;
  for (size_t i = 0; i < length; i++) {
    const char c = text[i];

    if (c == '\0' || isspace((unsigned char)c))
      return 0;
    if ((c == '+' || c == '-') && i > 0 && (isdigit((unsigned char)text[i - 1]) || text[i - 1] == '.'))
      copy[n++] = 'e'; /* three digits of an exponent leave Fortran no room for its E */
    copy[n++] = strchr("dDqQ", c) && i > 0 && (isdigit((unsigned char)text[i - 1]) || text[i - 1] == '.') ? 'e' : c;
    if (n >= sizeof copy - 1)
      return 0;
  }
  copy[n] = '\0';
  *value = strtod(copy, &end);
  return end != copy && *end == '\0';
}

int is_finite(const char *text, double *value)
{
  return text[0] && !isspace((unsigned char)text[0]) && !isspace((unsigned char)text[strlen(text) - 1])
         && !strpbrk(text, "xXpPnN") && af_number(text, strlen(text), value) && isfinite(*value);
}

int is_infinite(const char *text)
{
  double value;

  return af_number(text, strlen(text), &value) && isinf(value) && value > 0. && strpbrk(text, "iI");
}

const char *af_type_name(int type)
{
  static const char *const names[] = { "MX", "R4", "R3", "R2", "R1", "UZ", "ZH", "CP", "BT", "",
                                       "BP", "LP", "HB", "", "LP", "BP", "PD", "TR", "EP" };

  switch (type) {
  case -32: return "GH";
  case 23: case 83: return "LTR";
  case 77: case 87: return "PTR";
  case 28: case 78: return "LPD";
  case 88: return "TTR";
  default: return names[type % 10 + 9];
  }
}
