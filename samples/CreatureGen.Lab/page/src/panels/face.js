import { h } from '../dom.js';

/** The small picture of somebody, for a list. */
export const face = ({ thumb }) => h('img', { src: thumb ?? './egg.svg', alt: '', width: 44, height: 44 });
