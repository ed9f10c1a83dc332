using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Gaits;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Distance;

/// <summary>A walker as it is seen from afar: the cycles of its gaits, and the joint that tilts with the ground. Immutable, shared by all of the creature.</summary>
/// <param name="Gaits">Slow to fast.</param>
/// <param name="Cycles">One for each gait.</param>
/// <param name="Joint">Carries the body.</param>
/// <param name="Tilts">Part of the ground's tilt that the body takes: all on four legs and more, none on two.</param>
internal sealed record DistantBody(IReadOnlyList<Gait> Gaits, PoseCycle[] Cycles, int Joint, float Tilts)
{
    /// <summary>Steepest tilt that is taken, rise over way.</summary>
    private const float Steepest = 1f;

    /// <summary>The cycle to show for a gait: its own, or that of another for a gait that the creature does not have.</summary>
    /// <param name="gait">As it goes.</param>
    /// <param name="usual">Number of the gait that it would take by itself at its speed.</param>
    public int CycleOf(Gait gait, int usual)
    {
        for (int i = 0; i < Gaits.Count; i++)
        {
            if (ReferenceEquals(Gaits[i], gait))
            {
                return i;
            }
        }

        return Math.Min(usual, Cycles.Length - 1);
    }

    /// <summary>Writes the pose.</summary>
    /// <param name="cycle">Number of the cycle.</param>
    /// <param name="phase">Place in it, 0..1.</param>
    /// <param name="stride">Metres that it goes in a cycle; below 0 backwards.</param>
    /// <param name="normal">Out of the ground, model space, unit.</param>
    /// <param name="local">In the parents' space.</param>
    public void Pose(int cycle, float phase, float stride, Vector3 normal, in Pose local)
    {
        PoseCycle shown = Cycles[cycle];
        shown.Pose(stride < 0f ? 1f - phase : phase, Math.Min(Math.Abs(stride) / shown.Stride, 1f), local);
        Tilt(normal, local);
    }

    /// <summary>Tilts the body, and its feet with it, about the root.</summary>
    /// <param name="normal">Out of the ground, model space, unit.</param>
    /// <param name="local">In the parents' space.</param>
    private void Tilt(Vector3 normal, in Pose local)
    {
        float level = Tilts / Math.Max(normal.Y, 1e-3f);
        var slope = new Vector3(normal.X * level, 0f, normal.Z * level);
        float squared = Vec.LengthSquared(slope);
        if (squared == 0f)
        {
            return;
        }

        slope *= squared > Steepest * Steepest ? Steepest / (float)Math.Sqrt(squared) : 1f;
        Vector3 up = new Vector3(slope.X, 1f, slope.Z) / (float)Math.Sqrt(1f + Vec.LengthSquared(slope));
        Quaternion turn = UnitRotation.FromTo(Vector3.UnitY, up);
        local.Positions[Joint] = Rotation.Rotate(turn, local.Positions[Joint]);
        local.Rotations[Joint] = UnitRotation.Renormalize(Rotation.Multiply(turn, local.Rotations[Joint]));
    }
}
