#include "geom/shape.h"

#include <stdlib.h>
#include <string.h>

#include "base/arena.h"

void hit_list_init(HitList *list)
{
	list->hits = list->first;
	list->count = 0;
	list->capacity = HIT_LIST_INLINE;
}

void hit_list_free(HitList *list)
{
	if (list->hits != list->first)
		free(list->hits);
	hit_list_init(list);
}

void hit_list_grow(HitList *list)
{
	size_t capacity = (size_t)list->capacity * 2;
	if (list->hits == list->first) {
		list->hits = memory_alloc(capacity * sizeof(Hit));
		memcpy(list->hits, list->first, sizeof(list->first));
	} else {
		list->hits = memory_resize(list->hits, capacity * sizeof(Hit));
	}
	list->capacity = (int)capacity;
}

static int compare_hits(const void *a, const void *b)
{
	double ta = ((const Hit *)a)->t, tb = ((const Hit *)b)->t;
	return (ta > tb) - (ta < tb);
}

bool hit_nearest_by(ShapeCross *cross, const Shape *self, const Ray *ray, Hit *out)
{
	HitList list;
	hit_list_init(&list);
	cross(self, ray, 1, &list);
	bool found = list.count > 0;
	if (found)
		*out = list.hits[0];
	hit_list_free(&list);
	return found;
}

/* Lists are short as a rule, then insertion wins. */
void hit_list_sort(HitList *list)
{
	if (list->count > 64) {
		qsort(list->hits, (size_t)list->count, sizeof(Hit), compare_hits);
		return;
	}
	for (int i = 1; i < list->count; i++) {
		Hit hit = list->hits[i];
		int at = i;
		for (; at > 0 && list->hits[at - 1].t > hit.t; at--)
			list->hits[at] = list->hits[at - 1];
		list->hits[at] = hit;
	}
}
