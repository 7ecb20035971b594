/* SIGINT and SIGTERM: the first asks the work at hand to stop, a second ends the program at once,
 * with status 2. */
#ifndef CLI_INTERRUPT_H
#define CLI_INTERRUPT_H

#include <stdbool.h>

void interrupt_install(void);
/* While true (parsing, when nothing is being written) the first signal ends the program, too. */
void interrupt_end_at_once(bool at_once);
/* Nonzero after a signal. */
const volatile int *interrupt_flag(void);

#endif
