#include "render/reduction.h"

#include <stddef.h>

const ReductionMethod *reduction_find(Reduction reduction)
{
	static const ReductionMethod *const methods[] = {
		[REDUCTION_APA] = &reduction_apa, [REDUCTION_PPM] = NULL,
		[REDUCTION_APPM] = NULL,          [REDUCTION_CPPM] = NULL,
		[REDUCTION_SCHEDULE] = NULL,
	};
	return methods[reduction];
}
