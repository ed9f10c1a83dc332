using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf;

/// <summary>The names that enumerations have in extras. They are part of the format and outlive a renaming in code.</summary>
internal static class ExtrasNames
{
    public static readonly ChoiceNames<LimbKind> Limb = new(
        (LimbKind.Leg, "leg"),
        (LimbKind.Arm, "arm"),
        (LimbKind.Wing, "wing"),
        (LimbKind.InsectWing, "insectWing"),
        (LimbKind.Pectoral, "pectoral"),
        (LimbKind.Dorsal, "dorsal"),
        (LimbKind.Ventral, "ventral"),
        (LimbKind.Ear, "ear"),
        (LimbKind.Antenna, "antenna"),
        (LimbKind.Tail, "tail"),
        (LimbKind.Disc, "disc"));

    public static readonly ChoiceNames<Side> Side = new(
        (Anatomy.Side.Median, "median"),
        (Anatomy.Side.Left, "left"),
        (Anatomy.Side.Right, "right"));
}
