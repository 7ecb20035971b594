/* Exit statuses of cognac, as POV-Ray's. */
#ifndef CLI_STATUS_H
#define CLI_STATUS_H

typedef enum Status { STATUS_DONE = 0, STATUS_FAILED = 1, STATUS_STOPPED = 2 } Status;

#endif
