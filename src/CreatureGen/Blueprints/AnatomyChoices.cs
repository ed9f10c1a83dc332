using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>The names of the vocabulary of anatomy in JSON text.</summary>
internal static class AnatomyChoices
{
    public static readonly ChoiceNames<LocomotionKind> Kind = new(
        (LocomotionKind.Walking, "walking"),
        (LocomotionKind.Flying, "flying"),
        (LocomotionKind.Swimming, "swimming"));

    public static readonly ChoiceNames<BodyPlan> Plan = new(
        (BodyPlan.Digitigrade, "digitigrade"),
        (BodyPlan.Unguligrade, "unguligrade"),
        (BodyPlan.Plantigrade, "plantigrade"),
        (BodyPlan.Columnar, "columnar"),
        (BodyPlan.Upright, "upright"),
        (BodyPlan.Sprawling, "sprawling"),
        (BodyPlan.Theropod, "theropod"),
        (BodyPlan.Hexapod, "hexapod"),
        (BodyPlan.ManyLegged, "manyLegged"),
        (BodyPlan.Legless, "legless"),
        (BodyPlan.Centaur, "centaur"),
        (BodyPlan.Flapping, "flapping"),
        (BodyPlan.Buzzing, "buzzing"),
        (BodyPlan.Fish, "fish"),
        (BodyPlan.Eel, "eel"),
        (BodyPlan.Whale, "whale"),
        (BodyPlan.Flipper, "flipper"));

    public static readonly ChoiceNames<LimbArchetype> Archetype = new(
        (LimbArchetype.DigitigradeHind, "digitigradeHind"),
        (LimbArchetype.DigitigradeFore, "digitigradeFore"),
        (LimbArchetype.UnguligradeHind, "unguligradeHind"),
        (LimbArchetype.UnguligradeFore, "unguligradeFore"),
        (LimbArchetype.PlantigradeHind, "plantigradeHind"),
        (LimbArchetype.PlantigradeFore, "plantigradeFore"),
        (LimbArchetype.Column, "column"),
        (LimbArchetype.Sprawl, "sprawl"),
        (LimbArchetype.Theropod, "theropod"),
        (LimbArchetype.Insect, "insect"),
        (LimbArchetype.Arm, "arm"),
        (LimbArchetype.Bird, "bird"),
        (LimbArchetype.Raptorial, "raptorial"),
        (LimbArchetype.Jumper, "jumper"),
        (LimbArchetype.FrogHind, "frogHind"),
        (LimbArchetype.FrogFore, "frogFore"));

    public static readonly ChoiceNames<LegStance> Stance = new(
        (LegStance.Standing, "standing"),
        (LegStance.Hanging, "hanging"));

    public static readonly ChoiceNames<WingStyle> Wing = new(
        (WingStyle.Bat, "bat"),
        (WingStyle.Feathered, "feathered"),
        (WingStyle.Folded, "folded"),
        (WingStyle.Falcon, "falcon"),
        (WingStyle.Albatross, "albatross"),
        (WingStyle.Hummingbird, "hummingbird"),
        (WingStyle.Owl, "owl"),
        (WingStyle.Dragon, "dragon"),
        (WingStyle.Pterosaur, "pterosaur"),
        (WingStyle.GlidingLizard, "glidingLizard"),
        (WingStyle.FlyingFish, "flyingFish"));

    public static readonly ChoiceNames<ThinWingStyle> ThinWing = new(
        (ThinWingStyle.Blade, "blade"),
        (ThinWingStyle.DragonflyFore, "dragonflyFore"),
        (ThinWingStyle.DragonflyHind, "dragonflyHind"),
        (ThinWingStyle.ButterflyFore, "butterflyFore"),
        (ThinWingStyle.ButterflyHind, "butterflyHind"),
        (ThinWingStyle.MothFore, "mothFore"),
        (ThinWingStyle.MothHind, "mothHind"));

    public static readonly ChoiceNames<FootStyle> Foot = new(
        (FootStyle.Plain, "plain"),
        (FootStyle.Paw, "paw"),
        (FootStyle.Web, "web"),
        (FootStyle.Talon, "talon"),
        (FootStyle.Sucker, "sucker"),
        (FootStyle.Stump, "stump"),
        (FootStyle.Cloven, "cloven"));

    public static readonly ChoiceNames<FinPlace> FinPlace = new(
        (Anatomy.FinPlace.Dorsal, "dorsal"),
        (Anatomy.FinPlace.Ventral, "ventral"),
        (Anatomy.FinPlace.Pectoral, "pectoral"));

    public static readonly ChoiceNames<FinStyle> Fin = new(
        (FinStyle.Sail, "sail"),
        (FinStyle.Shark, "shark"),
        (FinStyle.Spiny, "spiny"),
        (FinStyle.Paddle, "paddle"),
        (FinStyle.Tuna, "tuna"),
        (FinStyle.Carp, "carp"),
        (FinStyle.Veil, "veil"),
        (FinStyle.Ray, "ray"),
        (FinStyle.Flying, "flying"));

    public static readonly ChoiceNames<TailStyle> Tail = new(
        (TailStyle.Plain, "plain"),
        (TailStyle.Fork, "fork"),
        (TailStyle.Fan, "fan"),
        (TailStyle.Lance, "lance"),
        (TailStyle.Fluke, "fluke"),
        (TailStyle.Feathers, "feathers"),
        (TailStyle.Lunate, "lunate"),
        (TailStyle.Heterocercal, "heterocercal"),
        (TailStyle.Truncate, "truncate"),
        (TailStyle.Veil, "veil"),
        (TailStyle.Whip, "whip"),
        (TailStyle.Paddle, "paddle"),
        (TailStyle.Club, "club"),
        (TailStyle.Prehensile, "prehensile"),
        (TailStyle.Stinger, "stinger"),
        (TailStyle.Saurian, "saurian"));

    public static readonly ChoiceNames<EyeStyle> Eye = new(
        (EyeStyle.Round, "round"),
        (EyeStyle.Slit, "slit"),
        (EyeStyle.Compound, "compound"),
        (EyeStyle.Bead, "bead"),
        (EyeStyle.Bar, "bar"));

    public static readonly ChoiceNames<TongueStyle> Tongue = new(
        (TongueStyle.None, "none"),
        (TongueStyle.Rounded, "rounded"),
        (TongueStyle.Forked, "forked"));

    public static readonly ChoiceNames<BeakStyle> Beak = new(
        (BeakStyle.Conical, "conical"),
        (BeakStyle.Hooked, "hooked"),
        (BeakStyle.Probe, "probe"),
        (BeakStyle.Flat, "flat"),
        (BeakStyle.Parrot, "parrot"),
        (BeakStyle.Large, "large"));

    public static readonly ChoiceNames<FeatureKind> Feature = new(
        (FeatureKind.Horn, "horn"),
        (FeatureKind.Spike, "spike"),
        (FeatureKind.Antenna, "antenna"),
        (FeatureKind.Mandible, "mandible"),
        (FeatureKind.Tusk, "tusk"),
        (FeatureKind.Tuft, "tuft"),
        (FeatureKind.Scute, "scute"),
        (FeatureKind.Lure, "lure"),
        (FeatureKind.Ocellus, "ocellus"),
        (FeatureKind.Antler, "antler"),
        (FeatureKind.Plate, "plate"),
        (FeatureKind.Club, "club"),
        (FeatureKind.Eye, "eye"),
        (FeatureKind.Tail, "tail"),
        (FeatureKind.Comb, "comb"));

    public static readonly ChoiceNames<ShellStyle> Shell = new(
        (ShellStyle.None, "none"),
        (ShellStyle.Carapace, "carapace"),
        (ShellStyle.Elytra, "elytra"));

    public static readonly ChoiceNames<PatternKind> Pattern = new(
        (PatternKind.Plain, "plain"),
        (PatternKind.Spots, "spots"),
        (PatternKind.Stripes, "stripes"),
        (PatternKind.Bands, "bands"),
        (PatternKind.Patches, "patches"),
        (PatternKind.Mottle, "mottle"),
        (PatternKind.Saddle, "saddle"),
        (PatternKind.Rosettes, "rosettes"),
        (PatternKind.Giraffe, "giraffe"),
        (PatternKind.Turing, "turing"));
}
