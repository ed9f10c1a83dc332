using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Grounds;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Growth;

/// <summary>What an update costs against joints, legs, creatures and the ground.</summary>
internal static class FrameGrowth
{
    private const float Step = 1f / 60f;

    /// <summary>Creatures of each kind in the plot of joints.</summary>
    private const int Bodies = 40;

    /// <summary>Creatures of each number of legs, of which the median is told.</summary>
    private const int BodiesPerLegs = 7;

    /// <summary>Updates that are timed together.</summary>
    private const int Updates = 60;
    private const int Rounds = 25;

    /// <summary>Rounds of a crowd, which takes long.</summary>
    private const int CrowdRounds = 8;

    /// <summary>Metres between the corners of a ground's triangles.</summary>
    private const float Cell = 1f;

    private static readonly int[] legPairs = { 1, 2, 3, 4, 5, 6, 8, 10, 12, 14, 16 };
    private static readonly int[] crowds = { 1, 4, 16, 64, 256, 1024, 4096 };
    private static readonly int[] groundSides = { 8, 32, 128, 512, 1024 };

    /// <summary>All plots.</summary>
    public static IEnumerable<Plot> Plots()
    {
        RequestedKind[] kinds = { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming };
        yield return new Plot("Update against joints", "joints", "µs an update", PlotScale.Scatter, Fastest.Warm(() => Array.ConvertAll(kinds, Joints)));
        yield return new Plot("Update against legs, median of walkers", "legs", "µs an update", PlotScale.Linear, new[] { Fastest.Warm(Legs) });
        yield return new Plot("Update in a crowd", "walkers of four legs", "µs an update", PlotScale.Logarithmic, new[] { Fastest.Warm(Crowds) });
        yield return new Plot("Update of a walker against its ground", "triangles of the ground", "µs an update", PlotScale.Logarithmic, new[] { Fastest.Warm(() => Grounds("mesh", Mesh)), Fastest.Warm(() => Grounds("height field", HeightField)) });
    }

    private static PlotSeries Joints(RequestedKind kind)
    {
        var points = new List<(double, double)>();
        for (ulong seed = 1; seed <= Bodies; seed++)
        {
            MotionProfile profile = Profile(seed, CreatureOptions.Default with { Kind = kind });
            points.Add((profile.Subject.Skeleton.Count, Cost(profile, FlatGround.Level)));
        }

        return new PlotSeries(kind.ToString(), points);
    }

    private static PlotSeries Legs()
    {
        var points = new List<(double, double)>();
        foreach (int pairs in legPairs)
        {
            CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Walking, MinLegPairs = pairs, MaxLegPairs = pairs };
            double[] costs = Enumerable.Range(1, BodiesPerLegs).Select(seed => Cost(Profile((ulong)seed, options), FlatGround.Level)).Order().ToArray();
            points.Add((2 * pairs, costs[costs.Length / 2]));
        }

        return new PlotSeries("median", points);
    }

    private static PlotSeries Crowds()
    {
        MotionProfile[] profiles = Quadrupeds(32);
        var points = new List<(double, double)>();
        foreach (int count in crowds)
        {
            CreatureAnimator[] animators = Enumerable.Range(0, count).Select(i => new CreatureAnimator(profiles[i % profiles.Length])).ToArray();
            MotionInput[] inputs = animators.Select(animator => Asked(animator.Profile)).ToArray();
            int times = Math.Max(1, crowds[^1] / 4 / count);
            points.Add((count, Fastest.Of(CrowdRounds, () =>
            {
                for (int time = 0; time < times; time++)
                {
                    for (int i = 0; i < animators.Length; i++)
                    {
                        animators[i].Update(Step, inputs[i], FlatGround.Level);
                    }
                }
            }) / (times * count)));
        }

        return new PlotSeries("each with an animator of its own", points);
    }

    private static PlotSeries Grounds(string name, Func<int, IGround> make)
    {
        MotionProfile profile = Quadrupeds(1)[0];
        return new PlotSeries(name, groundSides.Select(side => (2.0 * side * side, Cost(profile, make(side)))).ToArray());
    }

    private static MotionProfile[] Quadrupeds(int count)
    {
        CreatureOptions options = CreatureOptions.Default with { Kind = RequestedKind.Walking, MinLegPairs = 2, MaxLegPairs = 2 };
        return Enumerable.Range(1, count).Select(seed => Profile((ulong)seed, options)).ToArray();
    }

    private static MotionProfile Profile(ulong seed, CreatureOptions options) => new(CreatureGenerator.Generate(seed, options));

    private static MotionInput Asked(MotionProfile profile) => profile.Flight != null ? new MotionInput(5f, Medium: MotionMedium.Air)
        : new MotionInput(profile.Gaits == null ? 0.5f : profile.Gaits.Speeds[0].Comfortable);

    /// <summary>Microseconds of an update, going round in the middle of the ground.</summary>
    private static double Cost(MotionProfile profile, IGround ground)
    {
        var animator = new CreatureAnimator(profile);
        MotionInput asked = Asked(profile) with { YawRate = 0.3f };
        float height = asked.Medium == MotionMedium.Air ? 30f : 0f;
        return Fastest.Of(Rounds, () =>
        {
            animator.Teleport(new RootPlace(new Vector3(0f, height, 0f), Quaternion.Identity), ground);
            for (int i = 0; i < Updates; i++)
            {
                animator.Update(Step, asked, ground);
            }
        }) / Updates;
    }

    private static HeightFieldGround HeightField(int side) => new(Heights(side), side + 1, Cell, new Vector3(-0.5f * side * Cell, 0f, -0.5f * side * Cell));

    private static MeshGround Mesh(int side)
    {
        float[] heights = Heights(side);
        var positions = new Vector3[heights.Length];
        var triangles = new List<int>();
        for (int i = 0; i < positions.Length; i++)
        {
            int x = i % (side + 1), z = i / (side + 1);
            positions[i] = new Vector3((x - (0.5f * side)) * Cell, heights[i], (z - (0.5f * side)) * Cell);
            if (x < side && z < side)
            {
                triangles.AddRange(new[] { i, i + side + 1, i + 1, i + 1, i + side + 1, i + side + 2 });
            }
        }

        return new MeshGround(positions, triangles.ToArray());
    }

    /// <summary>Gentle bumps.</summary>
    private static float[] Heights(int side)
    {
        float[] heights = new float[(side + 1) * (side + 1)];
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i] = 0.02f * (((7 * (i % (side + 1))) + (13 * (i / (side + 1)))) % 11);
        }

        return heights;
    }
}
