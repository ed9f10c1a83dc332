import { h, choices, icon } from '../dom.js';
import { texts } from '../texts.js';
export class Grid {
  constructor() {}
  open() {}
}
