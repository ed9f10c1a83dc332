using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>Neck, head and tail of a flier: the neck stretches out and keeps the gaze level, the tail streams behind and steers.</summary>
internal sealed class FlightAxis
{
    private const double HeadPitchKept = 0.85;
    private const double HeadRollKept = 0.6;
    private const double NeckStretch = 0.40;
    private const double TailStream = 0.80;
    private const double TailYaw = 0.45;
    private const double TailBeat = 0.06;
    private const double TailHover = 0.25;

    private readonly AxialChain chain;
    private readonly int chest;
    private readonly int pelvis;
    private readonly double[] risen;

    public FlightAxis(Skeleton skeleton, AxialChain chain)
    {
        this.chain = chain;
        pelvis = chain.Count;
        for (int b = chain.Count - 1; b >= 0; b--)
        {
            JointRole role = skeleton.Joints[chain.Bones[b].Turn.Joint].Role;
            if (role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest)
            {
                chest = b;
                pelvis = Math.Max(b, pelvis == chain.Count ? b : pelvis);
            }
        }

        // Swimmers have neither: all behind the head counts as trunk.
        pelvis = Math.Min(pelvis, chain.Count - 1);
        risen = new double[chain.Count];
        for (int b = 0; b < risen.Length; b++)
        {
            Vector3 way = chain.Bones[b].Front - chain.Bones[b].Rear;
            risen[b] = PortableMath.Atan2(way.Y, way.Z);
        }
    }

    /// <summary>Writes the joints of the axis.</summary>
    public void Write(in Pose local, in AxisStroke stroke)
    {
        Span<Quaternion> turns = stackalloc Quaternion[chain.Count];
        Span<Vector3> pivots = stackalloc Vector3[chain.Count];
        for (int b = 0; b < chain.Count; b++)
        {
            turns[b] = b < chest ? Fore(b, stroke) : b > pelvis ? Aft(b, stroke) : Quaternion.Identity;
        }

        chain.Write(local, turns, pivots);
    }

    private Quaternion Fore(int b, in AxisStroke stroke)
    {
        double fraction = (double)(chest - b) / chest;
        double stretch = b == 0 ? 0 : NeckStretch * stroke.Stream * risen[b];
        double pitch = stretch - (fraction * HeadPitchKept * stroke.Pitch);
        return Rotation.Multiply(AxisRotation.Yaw(fraction * stroke.Look), Rotation.Multiply(AxisRotation.Pitch(pitch), AxisRotation.Roll(-fraction * HeadRollKept * stroke.Roll)));
    }

    private Quaternion Aft(int b, in AxisStroke stroke)
    {
        double fraction = (double)(b - pelvis) / (chain.Count - 1 - pelvis);
        double beat = TailBeat * stroke.Beat * fraction * PortableMath.Sin(2 * PortableMath.Pi * (stroke.Phase - 0.15 - (0.2 * fraction)));
        double pitch = (TailStream * stroke.Stream * risen[b]) + beat + (fraction * TailHover * stroke.Hover) - (fraction * 0.25 * stroke.Rise);
        return Rotation.Multiply(AxisRotation.Yaw(-fraction * TailYaw * stroke.Steer), AxisRotation.Pitch(pitch));
    }
}
