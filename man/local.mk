dist_man_MANS += man/cognac.1 man/cognac-compare.1 man/cognac-layer.1 man/cognac-merge.1 man/cognac-language.5 \
	man/cognac-photons.7
