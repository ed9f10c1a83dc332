using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>Hand-made spines and anatomies.</summary>
internal static class Spines
{
    /// <summary>Bones of two rings each from ring 22 on, level, with given widths; the front end is at z = 0.</summary>
    public static SpineMeasure Level(double[] widths, double boneLength, double height, double? bodyHeight = null, double? massZ = null, double thickness = 0.2)
    {
        double[] heights = new double[widths.Length];
        System.Array.Fill(heights, height);
        return Bent(widths, boneLength, heights, bodyHeight ?? height, massZ, thickness);
    }

    /// <summary>The same with a height for each bone.</summary>
    public static SpineMeasure Bent(double[] widths, double boneLength, double[] heights, double bodyHeight, double? massZ = null, double thickness = 0.2)
    {
        var bones = new SpineBone[widths.Length];
        for (int i = 0; i < bones.Length; i++)
        {
            bones[i] = new SpineBone(i, 23 + (2 * i), widths[i], boneLength, heights[i], thickness, -(i + 0.5) * boneLength);
        }

        int centre = bones.Length / 2;
        return new SpineMeasure(bones, boneLength * bones.Length, bodyHeight, centre, new SagittalPoint(bodyHeight, massZ ?? bones[centre].Z));
    }

    /// <summary>A socket of pillars at the side of every bone.</summary>
    public static SocketSet EveryBone(SpineMeasure measure, SocketBounds? bounds = null, LimbArchetype archetype = LimbArchetype.UnguligradeHind)
    {
        var sockets = new List<LimbSocket>();
        foreach (SpineBone bone in measure.Bones)
        {
            sockets.Add(new LimbSocket((int)bone.Ring, 8, archetype, 0.2, 0, 0, bounds ?? SocketBounds.Insect));
        }

        return Free(sockets);
    }

    /// <summary>An anatomy with the given places that asks for nothing more.</summary>
    public static SocketSet Free(IReadOnlyList<LimbSocket> sockets) =>
        new(BodyPlan.Digitigrade, sockets, 1, null, new StanceLimits(0.02, 0.4, -0.12, 0.12, 4, 1.3, BodyPlan.Sprawling, BodyPlan.Theropod));

    /// <summary>The nominal choice of the rules for legs, without what comes after.</summary>
    public static (WalkingRule Rule, List<int> Sockets) Choose(SpineMeasure measure, SocketSet set) =>
        LegRules.Choose(new LegField(measure, set, set.Legs, LegSize.Nominal, LegGirth.Nominal, 0));

    public static WalkingPlacement Place(SpineMeasure measure, SocketSet set, ulong seed = 1) => WalkingRules.Place(measure, set, LegSize.Nominal, new RandomStream(seed));

    /// <summary>A random body: 2 to 22 bones of varying size, curved, high or low, with the mass anywhere along it.</summary>
    public static SpineMeasure Random(RandomStream stream)
    {
        int count = stream.Integer(2, 23);
        double ringStep = 22.0 / count;
        double thick = stream.Uniform(0.05, 0.6);
        double step = stream.Uniform(0.3, 2.5) / count;
        double height = stream.Uniform(-0.2, 1.8);
        double slope = stream.Uniform(-1, 1);
        double variety = stream.Uniform(0, 1);
        var bones = new SpineBone[count];
        double y = height;
        double z = 0;
        for (int i = 0; i < count; i++)
        {
            double length = step * stream.Uniform(0.7, 1.3);
            double tilt = System.Math.Max(-0.9, System.Math.Min(0.9, slope + stream.Uniform(-0.3, 0.3)));
            double level = System.Math.Sqrt(1 - (tilt * tilt));
            double width = thick * (1 - (variety * stream.Uniform()) + 0.02);
            bones[i] = new SpineBone(i, 22 + ((i + 0.5) * ringStep), width, length, y - (0.5 * length * tilt), width * stream.Uniform(0.6, 1.6), z - (0.5 * length * level));
            y -= length * tilt;
            z -= length * level;
        }

        int centre = count / 2;
        double total = 0;
        foreach (SpineBone bone in bones)
        {
            total += bone.Length;
        }

        return new SpineMeasure(bones, total, bones[centre].Height, centre, new SagittalPoint(bones[centre].Height + stream.Uniform(0, 0.3), z * stream.Uniform(-0.2, 1.2)));
    }
}
