/* boundary.c - the algebraic problem of boundary.h, compiled once for all layouts
 *
 * A layout compiled with -DMLG_BOUNDARY gives its device, layout_network().
 */
#include "mlg.h"

struct network layout_network(const double par[]);
#define device_network layout_network

#include "boundary.h"
#include "unused.h"
