/* judging.c - mlg judge: is a run what it was meant to be?  See judge.h. */
#include <string.h>

#include "command.h"
#include "judge.h"
#include "runs.h"

static int run(int argc, char *argv[])
{
  struct text why = TEXT_NONE;
  struct judgement judgement;
  struct run_files files;
  int status = MLG_OK;

  if (argc < 2 || (argc > 2 && strcmp(argv[2], "--") != 0)) {
    fputs("usage: mlg judge RUN|FOLDER [-- TYPE=COUNT ...]\n", stderr);
    return MLG_BAD_INPUT;
  }
  if (check_expectations(argv + (argc > 3 ? 3 : argc), argc > 3 ? argc - 3 : 0, &why) != 0) {
    say_line("judge", why.at);
    text_free(&why);
    return MLG_BAD_INPUT;
  }
  if (find_run_or_say("judge", argv[1], &files) != 0)
    return MLG_BAD_INPUT;
  const struct judged judged = { files.b, files.s, files.d, files.log, files.layout, argv + 3, argc > 3 ? argc - 3 : 0, 0 };

  judge_run(&judged, &judgement);
  if (!judgement.whole && judgement.complaints.length == 0)
    text_add(&judgement.complaints, "what AUTO wrote is cut short (is the disk full?)");
  if (judgement.complaints.length > 0) {
    fprintf(stderr, "%s: %s\n", files.name, judgement.complaints.at);
    status = MLG_FAILED;
  } else
    puts(judgement.found.at);
  judgement_free(&judgement);
  free_run(&files);
  return status;
}

const struct command command_judge = {
  "judge", "RUN|FOLDER [-- TYPE=COUNT ...]",
  "is a run of AUTO what it was meant to be, and which points has it?",
  "RUN is one of build/runs, or FOLDER/NAME for AUTO's files b.NAME, d.NAME, s.NAME.\n"
  "TYPE=COUNT: how many points of a type it has to have; HH counts double Hopf points,\n"
  "closed the branches that end on a Hopf point.\n"
  "Prints the special points with the value of the first parameter, as in\n"
  "  HB 13.4308 HB 25.0861      TR 30.7865 closed      no special point\n"
  "Status 1 and one line when the run is rejected.\n",
  run,
};
