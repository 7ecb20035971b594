#include "cli/interrupt.h"

#include <signal.h>
#include <string.h>
#include <unistd.h>

#include "cli/status.h"

/* A signal handler gets no data of its own, so these two must stand at file scope. */
static volatile int interrupted;
static volatile int at_once_now;

static void on_signal(int number)
{
	(void)number;
	if (interrupted || at_once_now)
		_exit(STATUS_STOPPED);
	interrupted = 1;
}

void interrupt_install(void)
{
	struct sigaction action;
	memset(&action, 0, sizeof action);
	action.sa_handler = on_signal;
	sigaction(SIGINT, &action, NULL);
	sigaction(SIGTERM, &action, NULL);
}

void interrupt_end_at_once(bool at_once)
{
	at_once_now = at_once;
}

const volatile int *interrupt_flag(void)
{
	return &interrupted;
}
