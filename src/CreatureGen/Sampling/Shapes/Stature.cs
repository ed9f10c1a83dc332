using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Shapes;

/// <summary>How far the frame of a strange swimmer departs from those of its parents, which even one another out: how stout, how deep and how long it is, how large its head and its fins are. What goes on legs keeps its frame: its gaits were tuned to it.</summary>
/// <remarks>Each factor is the exponential of a normal draw, so that twice and half are as likely; without strangeness all of them are 1.</remarks>
internal static class Stature
{
    // Standard deviations of the logarithms at full strangeness.
    private const double Breadth = 0.2;
    private const double Depth = 0.22;
    private const double Length = 0.25;
    private const double Head = 0.12;
    private const double Fins = 0.35;

    /// <summary>Largest departure, standard deviations.</summary>
    private const double Most = 1.7;

    /// <summary>Most that a fin grows by: longer flippers are oars.</summary>
    private const double LongestFin = 1.15;

    /// <summary>How freely neck, tail and snout of a species vary: as its profile says without strangeness, as those of whole families with all of it.</summary>
    public static double Freely(CreatureBuilder builder, double variety) => Varies(builder) ? Math.Max(variety, Scalar.Lerp(variety, 1, builder.Strangeness)) : variety;

    /// <summary>The proportions with another head on a stouter or slighter, deeper or flatter trunk.</summary>
    public static BodyProportions Vary(CreatureBuilder builder, BodyProportions drawn) => drawn with
    {
        Head = drawn.Head * Factor(builder, "head", Head),
        Width = drawn.Width * Factor(builder, "breadth", Breadth),
        Depth = drawn.Depth * Factor(builder, "depth", Depth),
    };

    /// <summary>Factor on the length of the middle of the torso.</summary>
    public static double Torso(CreatureBuilder builder) => Factor(builder, "length", Length);

    /// <summary>Factor on the length of a fin, by its place in the list, or of the tail fin.</summary>
    public static double Fin(CreatureBuilder builder, int index) => Math.Min(LongestFin, Factor(builder, FormattableString.Invariant($"fin {index}"), Fins));

    /// <summary>Whether the frame varies; a disc keeps its outline.</summary>
    private static bool Varies(CreatureBuilder builder) => builder.Kind == LocomotionKind.Swimming && builder.Species.Disc.Sweep == 0;

    private static double Factor(CreatureBuilder builder, string name, double deviation)
    {
        if (!Varies(builder))
        {
            return 1;
        }

        RandomStream random = builder.Seed.Child("stature").Child(name).Stream();
        return PortableMath.Exp(builder.Strangeness * deviation * Scalar.Clamp(random.Normal(0, 1), -Most, Most));
    }
}
