const narrowest = 760;

/** Whether the window is one of a phone: the panel lies below the stage, and the machine is a small one. The same width as in the style sheet. */
export const isNarrow = () => innerWidth < narrowest;
