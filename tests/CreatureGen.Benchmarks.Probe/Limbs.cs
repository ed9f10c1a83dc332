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

    private static readonly Vector3[] targets = MakeTargets();

    // Not readonly, and the turns are kept: else a compiler with a profile takes a leg for constants and leaves out the half of the work that nobody asks for, and a solver takes half as long as with its callers.
    private static Vector3 thigh = new(0f, -0.5f, 0.1f);
    private static Vector3 shank = new(0f, -0.45f, -0.15f);
    private static Vector3 metatarsus = new(0f, -0.2f, 0.1f);
    private static Vector3 hinge = Vector3.UnitX;
    private static PantographLeg leg = new(thigh, shank, metatarsus, hinge);
    private static Reach reach = Reach.Default;
    private static Quaternion upperTurn;
    private static Quaternion lowerTurn;
    private static Quaternion footTurn;

    /// <summary>Solves a leg of two bones some times.</summary>
    public static void TwoBones(int times)
    {
        for (int i = 0; i < times; i++)
        {
            TwoBoneIk.Solve(Vector3.Zero, thigh, thigh + shank, hinge, targets[i % Targets], Vector3.UnitZ, reach, out upperTurn, out lowerTurn);
        }
    }

    /// <summary>Solves a leg of three bones some times.</summary>
    public static void Pantograph(int times)
    {
        for (int i = 0; i < times; i++)
        {
            PantographIk.Solve(leg, targets[i % Targets], hinge, 0.2f, reach, out upperTurn, out lowerTurn, out footTurn);
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
