/* networks.h - every series-parallel network of a few elements, as texts of device_text.h */
#ifndef MLG_NETWORKS_H
#define MLG_NETWORKS_H

#include <complex.h>

#include "device_text.h"

enum { NETWORK_TEXT = 80 };

/* text[n], to be freed. */
struct texts { char (*text)[NETWORK_TEXT]; int n, room; };

/* All networks of the named elements, each once: 1, 2, 8, 52, 472 of one to five. */
struct texts networks_of(const char *const name[], int n);

/* Static stiffness of what stands behind k_psi, N m/rad; 0: no path of springs. */
double network_static(const struct device_text *d, double k_d, double k_s);

/* The springs that carry a static torque: "k_d", "k_s", "k_d|k_s", "k_d-k_s" or "none". */
const char *network_path(const struct device_text *d);

/* The least k_s that is looked at, N m/rad, and so of any further spring: k_d where k_d is no
 * part of what carries, else 1e4. */
double network_least_k_s(const struct device_text *d, double k_d);

/* Whether two networks have the same dynamic stiffnesses, over all values above 0, k_d held
 * or free too: found by solving for the values, at random ones.  That of a further element
 * NAME=VALUE, one at most, does not stay. */
int network_same(struct device_text *a, struct device_text *b, int k_d_free);

/* Its dynamic stiffness at one s with these values of k_s, c_d and an element NAME=VALUE, which does
 * not stay; all others are the same every time. */
double _Complex network_at(struct device_text *d, double k_s, double c_d, double other);

/* Prints a row for each end, 0 or infinity, of k_s, c_d or the element NAME=VALUE at which network d,
 * of that number, is one of less[n]. */
void print_limits(int number, struct device_text *d, struct device_text less[], int n);

/* The networks of k_d, c_d and at most one of each of k_s and b that have a path of springs,
 * *all of them counted with those that have none.  The array is to be freed. */
struct device_text *small_networks(int *n, int *all);

#endif
