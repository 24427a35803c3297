/* mlg - what is to be known of a landing gear with a device, by one command
 *
 *   mlg COMMAND LAYOUT [NAME=VALUE ...] [gear=FILE]
 *   mlg help [COMMAND]
 *
 * Status 0; 1 when there is nothing to say or the output cannot be written, 2 at bad
 * input: one line on standard error says which word and what would be right.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "arguments.h"
#include "command.h"

/* In the order of `mlg help`, with the file of scripts/mlg/ that has it. */
#define COMMANDS_OF_MLG(X) \
  X(boundary)       /* gear/boundary.c */ \
  X(hopf)           /* gear/boundary.c */ \
  X(intervals)      /* gear/boundary.c */ \
  X(regions)        /* gear/regions.c */ \
  X(widest)         /* gear/regions.c */ \
  X(limits)         /* gear/limits.c */ \
  X(curves)         /* gear/curves.c */ \
  X(plane)          /* gear/plane.c */ \
  X(telling)        /* gear/telling.c */ \
  X(eigenvalues)    /* gear/eigenvalues.c */ \
  X(damping)        /* gear/damping.c */ \
  X(transients)     /* gear/transients.c */ \
  X(criticality)    /* gear/criticality.c */ \
  X(unfolding)      /* gear/unfolding.c */ \
  X(generalised)    /* gear/generalised.c */ \
  X(simulate)       /* gear/simulate.c */ \
  X(joints)         /* gear/joints.c */ \
  X(decay)          /* gear/decay.c */ \
  X(cycle)          /* gear/cycle.c */ \
  X(search)         /* gear/search.c */ \
  X(loads)          /* gear/loads.c */ \
  X(elasticities)   /* gear/elasticities.c */ \
  X(tolerance)      /* gear/tolerance.c */ \
  X(probability)    /* gear/probability.c */ \
  X(draw)           /* gear/draw.c */ \
  X(networks)       /* gear/networks.c */ \
  X(explore)        /* gear/explore.c */ \
  X(drawings)       /* gear/drawings.c */ \
  X(passive)        /* gear/passive.c */ \
  X(deltamode)      /* gear/deltamode.c */ \
  X(gear)           /* gear/gear.c */ \
  X(gearinfo)       /* gear/gearinfo.c */ \
  X(constants)      /* auto/checking.c */ \
  X(run)            /* auto/run.c */ \
  X(judge)          /* auto/judging.c */ \
  X(table)          /* auto/table.c */ \
  X(rows)           /* auto/rows.c */ \
  X(point)          /* auto/rows.c */ \
  X(points)         /* auto/points.c */ \
  X(shimmy)         /* auto/points.c */ \
  X(at)             /* auto/along.c */ \
  X(crossing)       /* auto/along.c */ \
  X(peak)           /* auto/along.c */ \
  X(orbit)          /* auto/orbit.c */ \
  X(grazing)        /* auto/grazing.c */ \
  X(curve)          /* auto/hopfcurve.c */ \
  X(widths)         /* auto/widths.c */ \
  X(starts)         /* auto/starts.c */ \
  X(agree)          /* auto/starts.c */ \
  X(stamp)          /* auto/uses.c */ \
  X(cases)          /* sweep/cases.c */ \
  X(cell)           /* report/expression.c */ \
  X(pick)           /* report/pick.c */ \
  X(areas)          /* report/areas.c */ \
  X(targets)        /* report/targets.c */ \
  X(fill)           /* report/fill.c */ \
  X(embed)          /* report/embed.c */ \
  X(strip)          /* report/strip.c */

/* Those that keep nothing from one call to the next; tests/sweeps.bats tries each. */
#define REPEATABLE(X) X(boundary) X(hopf) X(intervals) X(widest) X(eigenvalues) X(damping)

#define X(name) extern const struct command command_##name;
COMMANDS_OF_MLG(X)
#undef X

static const struct command *const commands[] = {
#define X(name) &command_##name,
  COMMANDS_OF_MLG(X)
#undef X
};

enum { COMMANDS = sizeof commands / sizeof *commands };

const struct command *find_command(const char *name)
{
  for (int i = 0; i < COMMANDS; i++)
    if (strcmp(commands[i]->name, name) == 0)
      return commands[i];
  return NULL;
}

static const char common[] =
  "NAME=VALUE: a parameter of models/mlg.h in SI units and radians; k_s=inf is rigid,\n"
  "compliance is 1e5/k_s, F_z the static load in place of M, V_top the top of the\n"
  "operating range (200 m/s).  gear=FILE: values from a file as constants/gear.printed.\n";

bool is_repeatable(const struct command *command)
{
#define X(name) if (command == &command_##name) return true;
  REPEATABLE(X)
#undef X
  return false;
}

static void list_commands(void)
{
  printf("mlg COMMAND LAYOUT [NAME=VALUE ...] [gear=FILE]\n\n");
  for (int i = 0; i < COMMANDS; i++)
    printf("  %-12s %s\n", commands[i]->name, commands[i]->summary);
  printf("  %-12s %s\n\nLAYOUT:", "help", "this list; `mlg help COMMAND` says more of one");
  for (int i = 0; i < libmlg_layouts(); i++)
    printf(" %s", libmlg_layout_name(i));
  printf("\n%s", common);
}

static int help(int argc, char *argv[])
{
  const struct command *c = argc > 1 ? find_command(argv[1]) : NULL;

  if (argc > 2)
    refuse("help", argv[2], "expected one command at most");
  if (argc > 1 && !c)
    refuse("help", argv[1], "no such command; `mlg help` lists them");
  if (c)
    printf("mlg %s %s\n\n%s.\n\n%s\n%s", c->name, c->usage, c->summary, c->details,
           strstr(c->usage, "NAME=VALUE") ? common : "");
  else
    list_commands();
  return output_status("help");
}

/* LAPACK's own, which it calls with an argument it cannot use, ends with status 0. */
_Noreturn void xerbla_(const char *name, const int *number, size_t length);

_Noreturn void xerbla_(const char *name, const int *number, size_t length)
{
  fprintf(stderr, "mlg: LAPACK's %.*s refuses its argument %d\n", (int)length, name, *number);
  exit(MLG_FAILED);
}

int main(int argc, char *argv[])
{
  const struct command *c = argc > 1 ? find_command(argv[1]) : NULL;

  if (argc < 2) {
    fprintf(stderr, "mlg: expected a command; `mlg help` lists them\n");
    return MLG_BAD_INPUT;
  }
  if (strcmp(argv[1], "help") == 0 || strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
    return help(argc - 1, argv + 1);
  if (!c) {
    fprintf(stderr, "mlg: '%s': no such command; `mlg help` lists them\n", argv[1]);
    return MLG_BAD_INPUT;
  }
  const int status = c->run(argc - 1, argv + 1);

  return status == MLG_OK ? output_status(argv[1]) : status;
}
