using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Crowds;

/// <summary>Many creatures of one kind on the march, each with an animator of its own and in another moment of its cycle.</summary>
internal sealed class Crowd
{
    /// <summary>Creatures on the scene: more than fit into the second level of a cache.</summary>
    public const int Count = 512;

    /// <summary>Different creatures among them.</summary>
    private const int Bodies = 32;

    /// <summary>Creatures that stay in the first levels of a cache.</summary>
    public const int Few = 8;

    private const int Rounds = 200;

    /// <summary>Rounds of the whole crowd, which needs the cache that other programs share: for seconds, so that some find it free.</summary>
    private const int CrowdRounds = 2000;
    private const float Step = 1f / 60f;

    private readonly CreatureAnimator[] animators = new CreatureAnimator[Count];
    private readonly Marcher[] marchers = new Marcher[Count];
    private readonly MotionInput[] inputs = new MotionInput[Count];

    /// <summary>Gathers a crowd.</summary>
    /// <param name="name">What it is called.</param>
    /// <param name="kind">How its creatures go.</param>
    /// <param name="chosen">Which creatures are wanted.</param>
    /// <param name="asked">What each is asked to do.</param>
    public Crowd(string name, RequestedKind kind, Predicate<MotionProfile> chosen, Func<MotionProfile, MotionInput> asked)
    {
        Name = name;
        var profiles = new List<MotionProfile>();
        for (ulong seed = 0; profiles.Count < Bodies && seed < 2000; seed++)
        {
            var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }));
            if (chosen(profile))
            {
                profiles.Add(profile);
            }
        }

        double joints = 0;
        for (int i = 0; i < Count; i++)
        {
            MotionProfile profile = profiles[i % profiles.Count];
            joints += profile.Subject.Skeleton.Count;
            inputs[i] = asked(profile);
            bool air = inputs[i].Medium == MotionMedium.Air;
            var place = new RootPlace(new Vector3(i * 10f, air ? 30f : 0f, 0f), Rotation.FromAxisAngle(Vector3.UnitY, 0.1 * i));
            animators[i] = new CreatureAnimator(profile);
            animators[i].Teleport(place, FlatGround.Level);
            marchers[i] = new Marcher(profile, inputs[i], place);
            for (int k = 0; k < 7 * i % 40; k++)
            {
                animators[i].Update(Step, inputs[i], FlatGround.Level);
            }
        }

        Joints = joints / Count;
    }

    public string Name { get; }

    /// <summary>Joints of a creature in the mean.</summary>
    public double Joints { get; }

    /// <summary>Microseconds of an update of each of a crowd that goes round.</summary>
    public double Update() => Best(Count, CrowdRounds, i => animators[i].Update(Step, inputs[i], FlatGround.Level));

    /// <summary>The same of so few that they stay in the nearest cache.</summary>
    public double UpdateOfFew() => Best(Few, Rounds * Count / Few, i => animators[i].Update(Step, inputs[i], FlatGround.Level));

    /// <summary>Microseconds of each stage, of few.</summary>
    public double[] Stages()
    {
        CrowdStage[] stages = Enum.GetValues<CrowdStage>();
        double[] best = new double[stages.Length];
        Array.Fill(best, double.MaxValue);
        int rounds = Rounds * Count / Few;
        for (int round = 0; round < rounds; round++)
        {
            for (int s = 0; s < stages.Length; s++)
            {
                long start = Stopwatch.GetTimestamp();
                for (int i = 0; i < Few; i++)
                {
                    marchers[i].Do(stages[s], Step);
                }

                best[s] = Math.Min(best[s], Microseconds(start) / Few);
            }
        }

        return best;
    }

    /// <summary>Microseconds of an action on one of a crowd: blocks of few are timed, and of each the quickest round counts, so that other programs on the machine do not.</summary>
    private static double Best(int count, int rounds, Action<int> action)
    {
        double[] best = new double[count / Few];
        Array.Fill(best, double.MaxValue);
        for (int round = 0; round < rounds; round++)
        {
            for (int block = 0; block < best.Length; block++)
            {
                long start = Stopwatch.GetTimestamp();
                for (int i = block * Few; i < (block + 1) * Few; i++)
                {
                    action(i);
                }

                best[block] = Math.Min(best[block], Microseconds(start));
            }
        }

        double sum = 0;
        foreach (double block in best)
        {
            sum += block;
        }

        return sum / count;
    }

    /// <summary>The most comfortable speed of the gait that a creature has at a place of its set, or of its fastest.</summary>
    public static MotionInput At(MotionProfile profile, int gait)
    {
        IReadOnlyList<GaitSpeed> speeds = profile.Gaits!.Speeds;
        return new MotionInput(speeds[Math.Min(gait, speeds.Count - 1)].Comfortable);
    }

    private static double Microseconds(long start) => (Stopwatch.GetTimestamp() - start) * 1e6 / Stopwatch.Frequency;
}
