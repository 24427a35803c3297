/* sums.c - sums of files, to notice damage and change; see sums.h */
#define _XOPEN_SOURCE 700
#include "sums.h"

#include <string.h>
#include <sys/stat.h>

static const uint64_t P1 = 0x9E3779B185EBCA87u, P2 = 0xC2B2AE3D27D4EB4Fu, P3 = 0x165667B19E3779F9u,
                      P4 = 0x85EBCA77C2B2AE63u, P5 = 0x27D4EB2F165667C5u;

static uint64_t turn(uint64_t x, int by)
{
  return x << by | x >> (64 - by);
}

/* little endian, whatever the machine */
static uint64_t word4(const unsigned char *p)
{
  return (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 | (uint64_t)p[3] << 24;
}

static uint64_t word8(const unsigned char *p)
{
  return word4(p) | word4(p + 4) << 32;
}

static uint64_t mixed(uint64_t sum, uint64_t x)
{
  return turn(sum + x * P2, 31) * P1;
}

uint64_t sum_of(const void *bytes, size_t length)
{
  const unsigned char *p = bytes, *const end = p + length;
  uint64_t sum = P5;

  if (length >= 32) {
    uint64_t lane[4] = { P1 + P2, P2, 0, 0u - P1 };

    for (; end - p >= 32; p += 32)
      for (int k = 0; k < 4; k++)
        lane[k] = mixed(lane[k], word8(p + 8 * k));
    sum = turn(lane[0], 1) + turn(lane[1], 7) + turn(lane[2], 12) + turn(lane[3], 18);
    for (int k = 0; k < 4; k++)
      sum = (sum ^ mixed(0, lane[k])) * P1 + P4;
  }
  sum += length;
  for (; end - p >= 8; p += 8)
    sum = turn(sum ^ mixed(0, word8(p)), 27) * P1 + P4;
  if (end - p >= 4) {
    sum = turn(sum ^ word4(p) * P1, 23) * P2 + P3;
    p += 4;
  }
  for (; p < end; p++)
    sum = turn(sum ^ *p * P5, 11) * P1;
  sum = (sum ^ sum >> 33) * P2;
  sum = (sum ^ sum >> 29) * P3;
  return sum ^ sum >> 32;
}

int sum_of_file(const char *file, uint64_t *sum, struct text *why)
{
  struct text text = TEXT_NONE;
  const int status = read_file(file, &text, why);

  if (status == 0)
    *sum = sum_of(text.at, text.length);
  text_free(&text);
  return status;
}

void look_of_file(const char *file, struct text *look)
{
  struct stat about;

  if (stat(file, &about) != 0)
    text_add(look, "-");
  else
    text_add(look, "%lld %lld.%09ld %llu", (long long)about.st_size, (long long)about.st_mtim.tv_sec, (long)about.st_mtim.tv_nsec,
             (unsigned long long)about.st_ino);
}
