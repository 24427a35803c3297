/* room.h - whether AUTO has room for all parameters
 *
 * AUTO's par[] is as long as the constant NPAR says, 36 if nothing does.  A parameter
 * behind its end would be read from, and written into, memory of something else.
 * Included behind AUTO's header.
 */
#ifndef MLG_ROOM_H
#define MLG_ROOM_H

/* NPAR as it stands in the constants file; a variable of AUTO's module auto_constants, by
 * the name that gfortran gives it.  Another compiler's AUTO does not link. */
extern integer auto_npar __asm__("__auto_constants_MOD_npar");

/* Ends the run, before anything is written, when par[] is shorter than slots. */
static void need_room(int slots)
{
  if (auto_npar >= slots)
    return;
  fprintf(stderr, "NPAR = %d: this model has parameters up to PAR(%d); its constants file has to say NPAR = %d\n",
          auto_npar, slots, slots);
  exit(2);
}

#endif
