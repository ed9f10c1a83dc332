namespace CreatureGen.Anatomy;

/// <summary>How a creature moves through its world.</summary>
public enum LocomotionKind
{
    /// <summary>On legs, or on its belly.</summary>
    Walking,

    /// <summary>On wings.</summary>
    Flying,

    /// <summary>In water.</summary>
    Swimming,
}

/// <summary>The overall build of a creature: how it carries its body.</summary>
public enum BodyPlan
{
    /// <summary>Four legs, standing on the toes (dog, cat).</summary>
    Digitigrade,

    /// <summary>Four legs, standing on hooves (deer, horse).</summary>
    Unguligrade,

    /// <summary>Four legs, standing on whole soles (bear).</summary>
    Plantigrade,

    /// <summary>Four pillars (elephant).</summary>
    Columnar,

    /// <summary>Two legs and two arms on an upright trunk.</summary>
    Upright,

    /// <summary>Legs out to the sides (lizard).</summary>
    Sprawling,

    /// <summary>Two strong legs under a level trunk (tyrannosaur, ostrich).</summary>
    Theropod,

    /// <summary>Three or four pairs of arched legs (beetle, spider).</summary>
    Hexapod,

    /// <summary>Three and more pairs of short legs along a long trunk.</summary>
    ManyLegged,

    /// <summary>No legs: the belly lies on the ground (snake).</summary>
    Legless,

    /// <summary>Four legs and a pair of arms in front of them.</summary>
    Centaur,

    /// <summary>A flier with one pair of flapping wings.</summary>
    Flapping,

    /// <summary>A flier with fast thin wings on its back.</summary>
    Buzzing,

    /// <summary>A swimmer driven by an upright tail fin.</summary>
    Fish,

    /// <summary>A long swimmer that undulates from head to tail.</summary>
    Eel,

    /// <summary>A swimmer driven by a level fluke.</summary>
    Whale,

    /// <summary>A swimmer that rows with four flippers.</summary>
    Flipper,
}

/// <summary>The built form of a leg or arm.</summary>
public enum LimbArchetype
{
    /// <summary>Hind leg on toes.</summary>
    DigitigradeHind,

    /// <summary>Fore leg on toes.</summary>
    DigitigradeFore,

    /// <summary>Hind leg on a hoof.</summary>
    UnguligradeHind,

    /// <summary>Fore leg on a hoof.</summary>
    UnguligradeFore,

    /// <summary>Hind leg on a sole.</summary>
    PlantigradeHind,

    /// <summary>Fore leg on a sole.</summary>
    PlantigradeFore,

    /// <summary>Pillar.</summary>
    Column,

    /// <summary>Leg out to the side.</summary>
    Sprawl,

    /// <summary>Leg of a running biped.</summary>
    Theropod,

    /// <summary>Arched leg of an insect.</summary>
    Insect,

    /// <summary>Arm with a hand.</summary>
    Arm,

    /// <summary>Slender leg of a bird.</summary>
    Bird,

    /// <summary>Folded grasping leg of a mantis.</summary>
    Raptorial,

    /// <summary>Hind leg of a grasshopper, its knee high above the back.</summary>
    Jumper,

    /// <summary>Folded hind leg of a frog.</summary>
    FrogHind,

    /// <summary>Fore leg of a frog.</summary>
    FrogFore,
}

/// <summary>What a leg does at rest.</summary>
public enum LegStance
{
    /// <summary>Its foot is on the ground: its length follows from the height of its socket.</summary>
    Standing,

    /// <summary>It hangs free: its length is its own.</summary>
    Hanging,
}

/// <summary>The built form of a wing.</summary>
public enum WingStyle
{
    /// <summary>A membrane between fingers.</summary>
    Bat,

    /// <summary>Rows of feathers.</summary>
    Feathered,

    /// <summary>Rows of feathers, folded back along the flank.</summary>
    Folded,

    /// <summary>Feathers, pointed and swept back.</summary>
    Falcon,

    /// <summary>Feathers, long and narrow.</summary>
    Albatross,

    /// <summary>Feathers, a short blade.</summary>
    Hummingbird,

    /// <summary>Feathers, broad, with slots between the outermost.</summary>
    Owl,

    /// <summary>A deep membrane between four fingers that end in hooks.</summary>
    Dragon,

    /// <summary>A narrow membrane behind one long finger.</summary>
    Pterosaur,

    /// <summary>A round membrane over ribs that spread from the flank.</summary>
    GlidingLizard,

    /// <summary>A long membrane over many rays that spread from the shoulder.</summary>
    FlyingFish,
}

/// <summary>Where a fin grows.</summary>
public enum FinPlace
{
    /// <summary>On the midline of the back.</summary>
    Dorsal,

    /// <summary>On the midline of the belly.</summary>
    Ventral,

    /// <summary>On both flanks.</summary>
    Pectoral,
}

/// <summary>The outline of a fin.</summary>
public enum FinStyle
{
    /// <summary>A rounded sail.</summary>
    Sail,

    /// <summary>A swept triangle.</summary>
    Shark,

    /// <summary>A row of spines.</summary>
    Spiny,

    /// <summary>A rounded paddle.</summary>
    Paddle,

    /// <summary>A narrow sickle on the flank, two peaks on the midline (tuna).</summary>
    Tuna,

    /// <summary>A broad rounded fan on the flank, a long one that falls off on the midline (carp).</summary>
    Carp,

    /// <summary>A long veil with a ragged edge (fighting fish).</summary>
    Veil,

    /// <summary>A wide triangle that runs along the flank, an even ribbon on the midline (ray, eel).</summary>
    Ray,

    /// <summary>A wing with rays on the flank (flying fish), a sail on the midline.</summary>
    Flying,
}

/// <summary>The end of the tail.</summary>
public enum TailStyle
{
    /// <summary>As the body tables give it.</summary>
    Plain,

    /// <summary>An upright forked fin.</summary>
    Fork,

    /// <summary>An upright rounded fin.</summary>
    Fan,

    /// <summary>An upright pointed fin.</summary>
    Lance,

    /// <summary>A level fluke.</summary>
    Fluke,

    /// <summary>A level fan of feathers.</summary>
    Feathers,

    /// <summary>An upright crescent on a narrow stalk (tuna).</summary>
    Lunate,

    /// <summary>An upright fin whose upper half is the longer one (shark).</summary>
    Heterocercal,

    /// <summary>An upright fin, cut off straight (bass).</summary>
    Truncate,

    /// <summary>An upright veil with a ragged edge (fighting fish).</summary>
    Veil,

    /// <summary>Tapers to a thread (mouse, iguana).</summary>
    Whip,

    /// <summary>Upright and flat towards its end (newt, crocodile).</summary>
    Paddle,

    /// <summary>Ends in a thick knob (ankylosaur).</summary>
    Club,

    /// <summary>Strong to its end, which rolls up (chameleon, monkey).</summary>
    Prehensile,

    /// <summary>A row of beads that ends in a bulb with a sting (scorpion).</summary>
    Stinger,

    /// <summary>Thick at its root and evenly down to a point (lizard, dinosaur).</summary>
    Saurian,
}

/// <summary>How an eye is made.</summary>
public enum EyeStyle
{
    /// <summary>Round pupil.</summary>
    Round,

    /// <summary>Upright slit pupil.</summary>
    Slit,

    /// <summary>Many facets, no pupil, no lids.</summary>
    Compound,

    /// <summary>A black bead without iris or lids (spider).</summary>
    Bead,

    /// <summary>Level bar pupil (goat, horse, toad).</summary>
    Bar,
}

/// <summary>The form of a tongue.</summary>
public enum TongueStyle
{
    /// <summary>None.</summary>
    None,

    /// <summary>Broad with a rounded tip.</summary>
    Rounded,

    /// <summary>Narrow with two points (snake).</summary>
    Forked,
}

/// <summary>Small solid parts that sit on the skin.</summary>
public enum FeatureKind
{
    /// <summary>Bony horn.</summary>
    Horn,

    /// <summary>Spike on the back.</summary>
    Spike,

    /// <summary>Feeler.</summary>
    Antenna,

    /// <summary>Jaw of an insect.</summary>
    Mandible,

    /// <summary>Long tooth outside the mouth.</summary>
    Tusk,

    /// <summary>Soft tuft of hair or feathers.</summary>
    Tuft,

    /// <summary>Horny scale that stands off the back.</summary>
    Scute,

    /// <summary>Feeler with a bright bulb at its end (angler fish).</summary>
    Lure,

    /// <summary>Further small black eye (spider).</summary>
    Ocellus,

    /// <summary>Branched horn (deer).</summary>
    Antler,

    /// <summary>Flat bony plate that stands on the back.</summary>
    Plate,

    /// <summary>Bony ball at the end of the tail.</summary>
    Club,

    /// <summary>A further eye; on a stalk where it is longer than two radii. On the midline a single one.</summary>
    Eye,

    /// <summary>A further tail.</summary>
    Tail,

    /// <summary>Lobes of flesh: on the midline a comb of five, elsewhere a pair of wattles (cock).</summary>
    Comb,
}

/// <summary>A hard cover over the back.</summary>
public enum ShellStyle
{
    /// <summary>None.</summary>
    None,

    /// <summary>A domed carapace of plates with an overhanging rim (turtle).</summary>
    Carapace,

    /// <summary>Two smooth wing cases that meet along the midline (beetle).</summary>
    Elytra,
}

/// <summary>Pattern of the coat.</summary>
public enum PatternKind
{
    /// <summary>One colour.</summary>
    Plain,

    /// <summary>Round spots.</summary>
    Spots,

    /// <summary>Narrow wavy stripes across the body.</summary>
    Stripes,

    /// <summary>Broad bands across the body.</summary>
    Bands,

    /// <summary>Large irregular patches.</summary>
    Patches,

    /// <summary>Fine clouds.</summary>
    Mottle,

    /// <summary>A dark saddle over the back.</summary>
    Saddle,

    /// <summary>Broken rings around a darker middle (leopard).</summary>
    Rosettes,

    /// <summary>Large plates with narrow seams between them.</summary>
    Giraffe,

    /// <summary>A labyrinth of winding ribbons of one width (puffer fish).</summary>
    Turing,
}

/// <summary>Left or right, as the creature itself would say it.</summary>
public enum Side
{
    /// <summary>On the sagittal plane.</summary>
    Median,

    /// <summary>+X.</summary>
    Left,

    /// <summary>−X.</summary>
    Right,
}
