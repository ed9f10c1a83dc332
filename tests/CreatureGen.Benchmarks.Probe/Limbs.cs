using System;
using System.Numerics;
#if EARLIER
using CreatureGen.Animation.Ik;
#else
using CreatureGen.Motion.Toolkit;
#endif

namespace CreatureGen.Benchmarks.Probe;

/// <summary>A leg that is solved for feet on a circle in front of it.</summary>
internal static class Limbs
{
    /// <summary>Targets in turn, so that the processor cannot guess the branches.</summary>
    private const int Targets = 16;

    private static readonly Vector3 thigh = new(0f, -0.5f, 0.1f);
    private static readonly Vector3 shank = new(0f, -0.45f, -0.15f);
    private static readonly Vector3 metatarsus = new(0f, -0.2f, 0.1f);
    private static readonly Vector3[] targets = MakeTargets();
    private static readonly PantographLeg leg = new(thigh, shank, metatarsus, Vector3.UnitX);
    private static readonly Reach reach = Reach.Default;

    /// <summary>Solves a leg of two bones some times.</summary>
    public static void TwoBones(int times)
    {
        for (int i = 0; i < times; i++)
        {
            TwoBoneIk.Solve(Vector3.Zero, thigh, thigh + shank, Vector3.UnitX, targets[i % Targets], Vector3.UnitZ, reach, out _, out _);
        }
    }

    /// <summary>Solves a leg of three bones some times.</summary>
    public static void Pantograph(int times)
    {
        for (int i = 0; i < times; i++)
        {
            PantographIk.Solve(leg, targets[i % Targets], Vector3.UnitX, 0.2f, reach, out _, out _, out _);
        }
    }

    private static Vector3[] MakeTargets()
    {
        var places = new Vector3[Targets];
        for (int i = 0; i < Targets; i++)
        {
            places[i] = new Vector3(0.01f * (i % 3), -0.8f + (0.02f * (i % 5)), (0.05f * (i % 7)) - 0.15f);
        }

        return places;
    }
}
