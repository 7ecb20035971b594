/*
 * How the tiles of `pavement` lie: which edges of a net of triangles, squares or hexagons part two
 * tiles. Measured from POV-Ray's pictures, tile by tile.
 */
#include "surface/pavement_plan.h"

#include <stddef.h>

/* For sides of 3, 4 and 6; of each the tiles of 1, 2, 3... polygons, and of those one by one. */
static const PavementPlan pavement_plans_3[] = {
	{1, 0, 1, "7"},
	{1, 0, 1, "5"},
	{3, 1, 1, "351"},
	{2, 1, 1, "51"},
	{2, 1, 1, "25"},
	{2, 0, 2, "3560"},
	{5, 2, 1, "31511"},
	{5, 2, 1, "31216"},
	{5, 2, 1, "51254"},
	{5, 3, 1, "31630"},
	{3, 0, 1, "311"},
	{3, 0, 1, "611"},
	{3, 1, 1, "611"},
	{3, 1, 2, "315160"},
	{3, 1, 2, "313230"},
	{3, 2, 2, "331212"},
	{2, 1, 3, "315412"},
	{2, 1, 3, "314503"},
	{3, 1, 2, "351250"},
	{3, 0, 1, "341"},
	{3, 1, 1, "350"},
	{3, 1, 1, "241"},
};

static const PavementPlan pavement_plans_4[] = {
	{1, 0, 1, "3"},
	{1, 0, 2, "31"},
	{3, 0, 1, "322"},
	{3, 0, 2, "332121"},
	{4, 0, 1, "3222"},
	{4, 0, 2, "33221221"},
	{4, 2, 1, "3221"},
	{2, 0, 2, "3210"},
	{2, 1, 2, "2330"},
	{5, 0, 1, "32222"},
	{5, 0, 2, "3322212221"},
	{5, 2, 2, "2323230010"},
	{5, 3, 1, "32221"},
	{5, 3, 1, "30213"},
	{10, 9, 1, "3112232211"},
	{10, 9, 1, "1312123212"},
	{10, 7, 1, "3221313120"},
	{5, 4, 1, "31221"},
	{5, 2, 2, "3302112213"},
	{5, 1, 2, "2322330320"},
	{10, 2, 1, "3223021131"},
	{6, 0, 1, "322222"},
	{6, 0, 2, "322223132220"},
	{6, 0, 2, "322223213220"},
	{6, 0, 2, "322223221320"},
	{6, 1, 1, "303222"},
	{6, 0, 2, "322232103200"},
	{6, 0, 2, "232322300210"},
	{6, 1, 1, "320322"},
	{3, 0, 2, "232300"},
	{3, 0, 2, "322100"},
	{4, 0, 3, "332212101021"},
	{6, 5, 1, "322121"},
	{4, 0, 3, "322231311202"},
	{3, 0, 4, "322213112023"},
	{3, 1, 2, "320310"},
	{6, 4, 1, "330210"},
	{6, 5, 2, "302231313202"},
	{6, 5, 2, "313220122231"},
	{6, 5, 1, "312211"},
	{6, 1, 1, "132203"},
	{6, 1, 1, "113222"},
	{4, 0, 3, "322213312012"},
	{4, 0, 3, "130212213131"},
	{6, 2, 2, "323201312212"},
	{2, 0, 3, "322112"},
	{2, 0, 3, "321021"},
	{2, 0, 3, "320312"},
	{6, 5, 1, "312212"},
	{6, 2, 2, "321312212032"},
	{6, 3, 2, "231221302132"},
	{6, 3, 2, "320231132203"},
	{6, 2, 1, "313202"},
	{3, 0, 4, "322321130122"},
	{12, 5, 1, "302231313220"},
	{4, 2, 3, "132012211331"},
};

static const PavementPlan pavement_plans_6[] = {
	{1, 0, 1, "7"},
	{2, 0, 1, "37"},
	{6, 4, 1, "677666"},
	{6, 2, 1, "277534"},
	{3, 0, 1, "375"},
	{8, 6, 1, "67766666"},
	{2, 0, 2, "3057"},
	{4, 0, 1, "7175"},
	{1, 0, 4, "6736"},
	{2, 0, 4, "33567576"},
	{2, 0, 4, "66347527"},
	{2, 0, 2, "6717"},
	{10, 8, 1, "6776666666"},
	{1, 0, 5, "73666"},
	{10, 8, 1, "2734766665"},
	{10, 8, 1, "6634766527"},
	{1, 0, 5, "63667"},
	{10, 8, 1, "2734276634"},
	{10, 8, 1, "2475242734"},
	{10, 7, 1, "7733465623"},
	{10, 4, 1, "7556337566"},
	{2, 0, 5, "3717376617"},
	{10, 4, 1, "2727143457"},
	{5, 1, 1, "47271"},
	{10, 2, 1, "7565371756"},
	{5, 4, 1, "67655"},
	{5, 4, 1, "57665"},
	{10, 4, 1, "7146557762"},
	{10, 6, 1, "1342376776"},
	{10, 4, 1, "1756673766"},
	{10, 2, 1, "5766173766"},
	{10, 8, 1, "2734576655"},
	{5, 4, 1, "57656"},
	{10, 4, 1, "3717665766"},
};

enum { PAVEMENT_TILES = 6 };

typedef struct PavementNet {
	int sides;
	int counts[PAVEMENT_TILES]; /* how many plans there are for tiles of 1, 2... polygons */
	const PavementPlan *plans;
} PavementNet;

static const PavementNet pavement_nets[] = {
	{3, {1, 1, 1, 3, 4, 12}, pavement_plans_3},
	{4, {1, 1, 2, 5, 12, 35}, pavement_plans_4},
	{6, {1, 1, 3, 7, 22, 0}, pavement_plans_6},
};

static const PavementNet *find_net(int sides)
{
	for (size_t i = 0; i < sizeof pavement_nets / sizeof *pavement_nets; i++)
		if (pavement_nets[i].sides == sides)
			return &pavement_nets[i];
	return NULL;
}

int pavement_plan_count(int sides, int tiles)
{
	const PavementNet *net = find_net(sides);
	return net && tiles >= 1 && tiles <= PAVEMENT_TILES ? net->counts[tiles - 1] : 0;
}

const PavementPlan *pavement_plan_find(int sides, int tiles, int pattern)
{
	if (pattern < 1 || pattern > pavement_plan_count(sides, tiles))
		return NULL;
	const PavementNet *net = find_net(sides);
	const PavementPlan *plan = net->plans + pattern - 1;
	for (int i = 0; i < tiles - 1; i++)
		plan += net->counts[i];
	return plan;
}

unsigned pavement_plan_borders(const PavementPlan *plan, int64_t i, int64_t j)
{
	int64_t up = j / plan->rows - (j % plan->rows < 0);
	j -= up * plan->rows;
	i = (i - up * plan->shift) % plan->columns;
	if (i < 0)
		i += plan->columns;
	return (unsigned)(plan->borders[j * plan->columns + i] - '0');
}
