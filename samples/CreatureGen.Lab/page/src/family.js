/** Who descends from whom: everybody who was met in a family, to walk back to and branch from. */
export class Family {
  constructor() {
    this.members = [];
    this.now = null;
  }

  /** A creature comes: a child of its parents, one who was here before, or, without parents, the first of a new family. */
  add(design, name, parents) {
    const known = this.members.find(member => member.design === design);
    if (known) {
      this.now = known;
      return known;
    }
    const real = (parents ?? []).filter(Boolean);
    if (real.length === 0) {
      this.members.length = 0;
    }
    this.now = this.#join(design, name, real);
    return this.now;
  }

  /** The other parent, from outside of the family. */
  guest({ design, name, thumb }) {
    const known = this.members.find(member => member.design === design);
    return known ?? Object.assign(this.#join(design, name, []), { thumb, generation: this.now?.generation ?? 0 });
  }

  /** Its generations, the oldest first. */
  get generations() {
    const rows = [];
    for (const member of this.members) {
      (rows[member.generation] ??= []).push(member);
    }
    return rows;
  }

  #join(design, name, parents) {
    const member = { design, name, parents, generation: parents.length ? 1 + Math.max(...parents.map(parent => parent.generation)) : 0, thumb: null };
    this.members.push(member);
    return member;
  }
}
