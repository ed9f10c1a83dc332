/** Whether somebody asked their system for less motion: then surroundings stand still, and what only decorates does not move. Creatures live all the same. */
export const wantsStillness = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
