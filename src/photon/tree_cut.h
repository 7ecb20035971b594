/*
 * Extents and cuts, compiled once for each instruction set: a file that includes this defines, on
 * eight 32-bit numbers at a time (type Eight),
 *
 *   lanes_load, lanes_store   of eight numbers in a row
 *   lanes_store_some          of the first of them
 *   lanes_min, lanes_max      of each lane
 *   lanes_least, lanes_most   of all lanes
 *   lanes_below               bit mask of the lanes less than a number
 *   lanes_equal               bit mask of the lanes that are a number
 *   eight_order               the numbers of a mask's lanes, at the front
 *   lanes_moved               one's lanes in the order of the other
 *   lanes_count               how many of an array's numbers are less than one
 *
 * and ORDERER, the name of what this defines.
 *
 * A cut first looks for the place, on the axis' column alone: two keys from a sorted sample that
 * most likely have it between them (Floyd & Rivest 1975) leave a few candidates, and counting how
 * many are below a guessed key ends the search. Then all columns are parted, without branches.
 */
#include <stdbool.h>

enum { MOST_SAMPLES = 127, FEW = 256 };

/* ---- extent ---- */

INLINE void column_extent(const int32_t *keys, uint32_t count, int32_t *lo, int32_t *hi)
{
	Eight least = lanes_load(keys), most = least;
	uint32_t i = 0;
	*lo = *hi = keys[0];
	if (count >= TREE_WIDTH) {
		for (; i + TREE_WIDTH <= count; i += TREE_WIDTH) {
			Eight some = lanes_load(keys + i);
			least = lanes_min(least, some);
			most = lanes_max(most, some);
		}
		*lo = lanes_least(least);
		*hi = lanes_most(most);
	}
	for (; i < count; i++) {
		*lo = keys[i] < *lo ? keys[i] : *lo;
		*hi = keys[i] > *hi ? keys[i] : *hi;
	}
}

static void run_extent(const TreeRun *run, TreeExtent *extent)
{
	for (int k = 0; k < run->dimensions; k++)
		column_extent(run->here[k], run->count, &extent->lo[k], &extent->hi[k]);
}

/* ---- the place of a cut ---- */

/* Points of a smaller key, or of this key and a smaller number, stay. */
typedef struct Place { int32_t key, number; } Place;

/* Keys of which the one with `wanted` smaller ones is looked for; those before were left out. */
typedef struct Search {
	const int32_t *keys;
	uint32_t count, wanted;
} Search;

static void sort_keys(int32_t *keys, int count)
{
	for (int i = 1; i < count; i++) {
		int32_t key = keys[i];
		int k = i;
		for (; k > 0 && keys[k - 1] > key; k--)
			keys[k] = keys[k - 1];
		keys[k] = key;
	}
}

/* Two keys that most likely have the wanted one between them. */
static void choose_keys(const Search *s, int32_t *low, int32_t *high)
{
	int32_t keys[MOST_SAMPLES];
	int samples = s->count >= 16384 ? MOST_SAMPLES : s->count >= 1024 ? 31 : 15;
	for (int i = 0; i < samples; i++)
		keys[i] = s->keys[(uint64_t)i * s->count / (uint64_t)samples];
	sort_keys(keys, samples);
	int at = (int)((uint64_t)s->wanted * (uint64_t)samples / s->count);
	int beyond = (samples + 8) / 16 + 1;
	*low = keys[at > beyond ? at - beyond : 0];
	*high = keys[at + beyond < samples ? at + beyond : samples - 1];
}

/* Keys from low to high go to `out`; returns how many. */
INLINE uint32_t sift(const Search *s, int32_t low, int32_t high, int32_t *out, uint32_t *below)
{
	uint32_t taken = 0, less = 0, i = 0;
	for (; i + TREE_WIDTH <= s->count; i += TREE_WIDTH) {
		Eight some = lanes_load(s->keys + i);
		unsigned under = lanes_below(some, low);
		unsigned upto = lanes_below(some, high) | lanes_equal(some, high);
		less += (unsigned)__builtin_popcount(under);
		lanes_store(out + taken, lanes_moved(some, eight_order(upto & ~under)));
		taken += (unsigned)__builtin_popcount(upto & ~under);
	}
	for (; i < s->count; i++) {
		int32_t key = s->keys[i];
		less += key < low;
		out[taken] = key;
		taken += (key >= low) & (key <= high);
	}
	*below = less;
	return taken;
}

/* One step of the search among many keys. out: room for all of them, not where they are. True when
 * the key is found. */
static bool narrow(Search *s, int32_t *out, int32_t *key)
{
	int32_t low, high;
	uint32_t below, taken;
	choose_keys(s, &low, &high);
	taken = sift(s, low, high, out, &below);
	if (taken == s->count) { /* no progress: one key alone must do */
		high = low;
		taken = sift(s, low, high, out, &below);
	}
	*key = low;
	if (s->wanted >= below && s->wanted < below + taken && low == high)
		return true;
	if (s->wanted < below) {
		uint32_t none;
		*s = (Search){out, sift(s, INT32_MIN, low - 1, out, &none), s->wanted};
	} else if (s->wanted < below + taken) {
		*s = (Search){out, taken, s->wanted - below};
	} else {
		uint32_t less, rest = sift(s, high + 1, INT32_MAX, out, &less);
		*s = (Search){out, rest, s->wanted - less};
	}
	return false;
}

/* Among few keys, by counting: in proportion, every third time in the middle. Any key between the
 * wanted one and the one before will do. */
INLINE int32_t search_few(const Search *s)
{
	int64_t lo, hi;
	int32_t least, most;
	uint32_t below_lo = 0, below_hi = s->count;
	column_extent(s->keys, s->count, &least, &most);
	lo = least;            /* below_lo <= wanted are less */
	hi = (int64_t)most + 1; /* below_hi > wanted are less */
	for (int step = 0; below_lo < s->wanted && hi - lo > 1; step++) {
		float share = step % 3 == 2 ? 0.5f : ((float)s->wanted - (float)below_lo) /
							 (float)(below_hi - below_lo);
		int64_t guess = lo + (int64_t)((float)(hi - lo) * share);
		guess = guess > lo ? guess < hi ? guess : hi - 1 : lo + 1;
		uint32_t below = lanes_count(s->keys, s->count, (int32_t)guess);
		if (below > s->wanted) {
			hi = guess;
			below_hi = below;
		} else {
			lo = guess;
			below_lo = below;
		}
	}
	return (int32_t)lo;
}

/* Of points with the key, `left` of the run's in all are to stay. */
static Place part_equals(const TreeRun *run, int axis, int32_t key, uint32_t left)
{
	const int32_t *keys = run->here[axis], *numbers = run->here[run->dimensions];
	uint32_t stay = left - lanes_count(keys, run->count, key), i = 0;
	if (stay == 0)
		return (Place){key, INT32_MIN};
	for (;; i++) {
		if (keys[i] == key && stay-- == 0)
			return (Place){key, numbers[i]};
	}
}

INLINE Place find_place(const TreeRun *run, int axis, uint32_t left)
{
	Search search = {run->here[axis], run->count, left};
	int32_t key = 0;
	bool found = false;
	for (int turn = 0; search.count > FEW && !found; turn ^= 1)
		found = narrow(&search, run->there[turn], &key);
	if (!found)
		key = search_few(&search);
	return part_equals(run, axis, key, left);
}

/* ---- parting ---- */

INLINE unsigned staying(const TreeRun *run, int axis, uint32_t at, Place place)
{
	Eight keys = lanes_load(run->here[axis] + at);
	Eight numbers = lanes_load(run->here[run->dimensions] + at);
	return lanes_below(keys, place.key) |
	       (lanes_equal(keys, place.key) & lanes_below(numbers, place.number));
}

/* Eight points, those that stay to `left` here, the others to `right` there. */
typedef struct Parting {
	uint32_t at, left, right;
	unsigned stay, go; /* masks */
} Parting;

INLINE void part_eight(const TreeRun *run, int columns, const Parting *p)
{
	Eight staying = eight_order(p->stay), going = eight_order(p->go);
	for (int k = 0; k < columns; k++) {
		Eight some = lanes_load(run->here[k] + p->at);
		lanes_store(run->here[k] + p->left, lanes_moved(some, staying));
		lanes_store(run->there[k] + p->right, lanes_moved(some, going));
	}
}

/* The same without writing behind the run's end, where others may be at work. */
INLINE void part_last(const TreeRun *run, int columns, const Parting *p)
{
	Eight staying = eight_order(p->stay), going = eight_order(p->go);
	for (int k = 0; k < columns; k++) {
		Eight some = lanes_load(run->here[k] + p->at);
		lanes_store(run->here[k] + p->left, lanes_moved(some, staying));
		lanes_store_some(run->there[k] + p->right, lanes_moved(some, going),
				 __builtin_popcount(p->go));
	}
}

INLINE void part_columns(const TreeRun *run, int columns, int axis, uint32_t first_right,
			 Place place)
{
	Parting p = {.left = 0, .right = first_right};
	for (p.at = 0; p.at < run->count; p.at += TREE_WIDTH) {
		uint32_t rest = run->count - p.at;
		unsigned valid = rest < TREE_WIDTH ? (1u << rest) - 1 : 255;
		p.stay = staying(run, axis, p.at, place) & valid;
		p.go = ~p.stay & valid;
		if (p.right + TREE_WIDTH <= run->count)
			part_eight(run, columns, &p);
		else
			part_last(run, columns, &p);
		p.left += (unsigned)__builtin_popcount(p.stay);
		p.right += (unsigned)__builtin_popcount(p.go);
	}
}

static void run_cut(const TreeRun *run, int axis, uint32_t left)
{
	Place place = find_place(run, axis, left);
	if (run->dimensions == 3)
		part_columns(run, 4, axis, left, place);
	else
		part_columns(run, TREE_COLUMNS, axis, left, place);
}

const TreeOrderer ORDERER = {run_extent, run_cut};
