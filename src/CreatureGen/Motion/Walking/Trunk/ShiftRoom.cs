using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Idle;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>
/// How far a body that stands shifts its weight over feet that are not where they are on level ground: no farther than legs out to the side reach, for which it does not come down.
/// A foot on a lower tread, or on a much higher one, would be drawn along.
/// </summary>
internal struct ShiftRoom
{
    /// <summary>Part of its reach to which a leg is stretched by it at most.</summary>
    private const float MaxStretch = 0.97f;

    /// <summary>How far below or above where it stands on level ground a foot is from which on it bounds the body wholly, leg lengths.</summary>
    private const float WhollyOff = 0.05f;

    /// <summary>How quickly it takes up what it has been kept from, leg lengths per second.</summary>
    private const float Rate = 0.5f;

    private float shift;
    private bool kept;

    /// <summary>What it does of its idle motion.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="feet">As they were posed last, with the shift of then.</param>
    /// <param name="idle">What it would do on level ground.</param>
    /// <param name="dt">Seconds since then.</param>
    public IdlePose Bound(LeggedBody body, ReadOnlySpan<Foot> feet, in IdlePose idle, float dt)
    {
        float wanted = idle.Shift;
        if (!body.Legs[0].Lateral)
        {
            return idle;
        }

        float most = kept ? Rate * body.LegLength * dt : float.MaxValue;
        float left = most;
        float right = -most;
        for (int i = 0; i < feet.Length; i++)
        {
            LegRig leg = body.Legs[i];
            if (feet[i].Phase == FootPhase.Stance)
            {
                Vector3 chord = feet[i].Leg.Chord;
                float off = Scalar.Smooth(Math.Abs(leg.Parts.Upper.Y + leg.Shank.Y - chord.Y) / (WhollyOff * leg.Length));
                if (off == 0f)
                {
                    continue;
                }

                float max = Math.Max(MaxStretch, leg.RestStretch) * leg.Reach;
                float room = (float)Math.Sqrt(Math.Max((max * max) - (chord.Y * chord.Y) - (chord.Z * chord.Z), 0f));
                left = Math.Min(left, Math.Max(chord.X + room, 0f) / off);
                right = Math.Max(right, Math.Min(chord.X - room, 0f) / off);
            }
        }

        float bounded = shift + Scalar.Clamp(wanted - shift, right, left);
        kept = bounded != wanted;
        shift = bounded;
        float share = kept && wanted != 0f ? Scalar.Clamp(bounded / wanted, 0f, 1f) : 1f;
        return kept ? idle with { Shift = bounded, Roll = idle.Roll * share, Yaw = idle.Yaw * share } : idle;
    }
}
