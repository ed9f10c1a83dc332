using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Trunk;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>Writes the trunk and the legs into a local pose.</summary>
internal sealed class LegPoser
{
    /// <summary>How often a foot that yields to its joints is laid on the ground anew at most, and that of a leg that is not folded up.</summary>
    private const int RelaxationRounds = 3;
    private const int OpenRounds = 5;

    /// <summary>How much farther it is laid at most than its joints ask at that moment, since they ask for more as it is laid; of legs that are folded up, whose joints ask for more than that, no farther: half the angles in radians.</summary>
    private const float MostGain = 1.5f;
    private const float Foreseen = 0.12f;
    private const float Unforeseen = 0.2f;

    /// <summary>How far a flat foot that trails behind is pointed beyond its pitch in the swing, radians.</summary>
    private const float TrailedPitch = 0.9f;

    /// <summary>Tangent of half the turn beyond its fold from which on an ankle is taken for stretched too far instead: 170 degrees.</summary>
    private const float FarBeyond = 11.43f;

    /// <summary>How close to its hip a foot that is carried over something passes below it, parts of the length of the leg as folded as it gets.</summary>
    private const float NearestPass = 0.7f;

    /// <summary>How high it is carried over something from which on it does so wholly, leg lengths.</summary>
    private const float WhollyOver = 0.08f;

    /// <summary>Part of the height of its swing from which on a foot out to the side goes past its hip wholly outside.</summary>
    private const float WhollyOutside = 0.67f;

    private readonly LeggedBody body;
    private readonly RestRotations turns;

    public LegPoser(LeggedBody body, RestRotations turns)
    {
        this.body = body;
        this.turns = turns;
    }

    /// <summary>Writes body, spine and chest; the pelvis stays as it is at rest under the body.</summary>
    public void PoseTrunk(BodyPlacer placer, in Pose local)
    {
        // The body's own joint goes half way with pitch and roll; it carries the place of all.
        TrunkChain trunk = placer.Trunk;
        ReadOnlySpan<Vector3> rest = body.Skeleton.ModelPositions;
        Quaternion whole = trunk.Turns[0];
        Vector3 place = trunk.Positions[0] - Rotation.Rotate(whole, trunk.Rest[0] - rest[body.Body]);
        turns.Set(local, body.Body, whole);
        local.Positions[body.Body] = place;
        for (int i = 1; i < body.Trunk.Length; i++)
        {
            turns.Set(local, body.Trunk[i], trunk.LocalTurn(i));
        }
    }

    /// <summary>Solves and writes a leg.</summary>
    /// <param name="index">Which.</param>
    /// <param name="placer">Gives trunk and hip.</param>
    /// <param name="foot">Its foot.</param>
    /// <param name="pose">Where the leg has to bring it.</param>
    /// <param name="tuck">How far legs ahead of the hindmost pair are folded to the body in the air, 0..1.</param>
    /// <param name="trail">How far those of the hindmost pair are stretched out behind, 0..1.</param>
    /// <param name="local">The pose.</param>
    public void PoseLeg(int index, BodyPlacer placer, ref Foot foot, in FootPose pose, float tuck, float trail, in Pose local)
    {
        LegRig leg = body.Legs[index];
        Quaternion carrier = placer.Trunk.Turns[leg.TrunkSlot];
        Vector3 hip = placer.HipOf(index, foot, out Vector3 slide);
        turns.Slide(local, leg.Girdle, slide);
        float carried = Carried(leg, foot, tuck, trail);
        bool stands = foot.Phase == FootPhase.Stance && foot.Taken == 0f;
        Solve(leg, carrier, hip, pose, carried, ref foot, local, out LegRotations solved);
        FootPose wanted = pose;
        if (carried > 0f && leg.Row == 0 && leg.Traits.Linkage == LegLinkage.Foot)
        {
            // Not before the toes are well off the ground: a hip may keep the leg from where it is carried.
            float raised = LegSolver.EndOf(leg, leg.Parts, solved).Y - (pose.Target.Y - hip.Y - foot.Path.Lift);
            float clear = Scalar.Smooth(raised / (Vec.Length(leg.Metatarsus) + leg.Toe));
            Quaternion point = AxisRotation.About(leg.RollAxis, carried * carried * carried * clear * TrailedPitch);
            wanted.Foot = Rotation.Multiply(wanted.Foot, point);
            wanted.Toes = Rotation.Multiply(wanted.Toes, point);
        }

        if (carried > 0f && leg.Lateral)
        {
            // Folded to the body it goes along with its shank, whose turn an ankle does not undo.
            wanted.Foot = UnitRotation.Nlerp(wanted.Foot, solved.Shank, carried);
            wanted.Toes = UnitRotation.Nlerp(wanted.Toes, solved.Shank, carried);
        }

        if (carried > 0f && leg.Traits.Linkage == LegLinkage.Foot)
        {
            // It turns about its ankle, which the leg brings to where it is: its ball goes along.
            wanted.Ball = wanted.Target + Rotation.Rotate(wanted.Foot, leg.Metatarsus);
        }

        HipLimit limit = HipLimit.Of(foot);
        float far = foot.Phase == FootPhase.Swing ? FarBeyond : float.PositiveInfinity;
        float laid = limit.Laid(leg);
        bool linked = leg.Traits.Linkage == LegLinkage.Pantograph;
        Quaternion metatarsus = PoseFoot(leg, solved, wanted, local, far, laid, out Vector3 astray, out float excess);
        foot.Leg.Relaxation = foot.Phase == FootPhase.Swing ? foot.Leg.Relaxation : excess;
        float fraction = excess > 0f ? limit.Relaxed(leg, foot, excess) : 0f;
        bool turned = stands && fraction > 0f;
        float pitch = FootRoll.SolePitch(leg, foot.Path.Posture.Shown.Pitch);

        // As the ankle comes up for it the shank leans farther, and asks for more. A foot that stands is laid until it is there, each time as much farther as the last was too little: what was left of it came and went, and dragged the foot. Those of linked legs get there by themselves.
        float renewed = stands ? 1f : laid;
        float asked = excess;
        float gain = stands && !linked ? MostGain - ((MostGain - 1f) * Scalar.Smooth((excess - Foreseen) / (Unforeseen - Foreseen))) : 1f;
        int rounds = renewed == 0f ? 1 : gain > 1f ? OpenRounds : RelaxationRounds;
        for (int i = 0; i < rounds && fraction > 0f && excess > 0f; i++)
        {
            Quaternion level = wanted.Toes;
            Quaternion toes = Rotation.Multiply(metatarsus, turns.Of(local, leg.Ball));
            LimitRelaxation.Turn(leg, foot.Path.Normal, linked ? toes : metatarsus, toes, pitch, fraction, ref wanted);
            if (stands)
            {
                if (i == 0)
                {
                    SoleHold.RollDown(leg, pose, ref foot, ref wanted);
                }

                SoleHold.Keep(leg, ref foot, ref wanted);
            }

            wanted.Target -= astray * fraction;
            Solve(leg, carrier, hip, wanted, carried, ref foot, local, out solved);

            // On the ground the toes lie as was found; in the air those of a linked leg go along with its ankle anew, the more the farther they are from their stances.
            FootPose lying = wanted;
            if (linked && !stands)
            {
                lying.Toes = UnitRotation.Nlerp(level, wanted.Toes, limit.Held);
            }

            metatarsus = PoseFoot(leg, solved, lying, local, far, stands ? 1f : linked ? limit.Held : laid, out astray, out excess);
            if (stands)
            {
                fraction = excess < asked ? Math.Min(fraction / Math.Max(1f - (excess / asked), 1f / gain), gain) : Math.Min(fraction, 1f);
            }
            else
            {
                fraction *= i == 0 ? renewed : 1f;
            }

            asked = excess;
        }

        foot.Leg.Turned.Stood = false;
        if (turned)
        {
            SoleHold.Remember(ref foot, wanted);
        }
    }

    /// <summary>How far a leg in the air is where the body carries it instead of on its foot's way, 0..1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Carried(LegRig leg, in Foot foot, float tuck, float trail)
    {
        float fraction = leg.Row > 0 ? tuck : trail;
        return fraction == 0f || foot.Phase != FootPhase.Swing ? 0f : fraction * (leg.Row > 0 ? LegGaitParameters.TuckCurve : LegGaitParameters.TrailCurve).At(foot.Swing);
    }

    /// <summary>Solves hip and knee and writes them.</summary>
    private void Solve(LegRig leg, Quaternion carrier, Vector3 hip, in FootPose pose, float carried, ref Foot foot, in Pose local, out LegRotations solved)
    {
        Vector3 chord = pose.Target - hip;
        float ground = chord.Y - foot.Path.Lift;
        if (carried > 0f)
        {
            // Where the body carries it, and not through the ground: a body that brakes is lower than one that leaps.
            chord = Vec.Lerp(chord, Rotation.Rotate(carrier, leg.Row > 0 ? leg.Tucked : leg.Trailed), carried);
            chord.Y = Math.Max(chord.Y, ground + foot.Path.Over);
        }

        if (foot.Path.Over > 0f && !leg.Lateral)
        {
            float above = chord.Y - Math.Max(Underneath(leg, chord), ground + foot.Path.Over);
            chord.Y -= Math.Max(above, 0f) * Scalar.Smooth(foot.Path.Over / (WhollyOver * leg.Length));
        }

        LegSegments folded = default;
        scoped ref readonly LegSegments parts = ref leg.Parts;
        if (pose.Fold != 0f)
        {
            folded = new LegSegments(leg.Thigh + Rotation.Rotate(AxisRotation.About(leg.Hinge, pose.Fold), leg.Metatarsus), leg.Shank, leg.Hinge, leg.MinBendCosine);
            parts = ref folded;
        }

        HipLimit limit = HipLimit.Of(foot);
        float lifted = foot.Phase == FootPhase.Swing ? leg.Traits.LiftCurve.At(foot.Swing) : 0f;
        var goal = new LegGoal(leg.Lateral && lifted > 0f ? LegSolver.Outside(leg, carrier, chord, ground, Scalar.Smooth(lifted / WhollyOutside)) : chord, foot.Path.Heading, foot.Path.Lean, limit.Slack, limit.Tolerance, leg.Lateral ? Vector3.Zero : foot.Path.Normal * limit.Standing);
        bool bent = !Aim(leg, parts, carrier, goal, local, out solved);
        if (bent)
        {
            Vector3 away = foot.Path.Away;
            float way = Vec.Dot(away, pose.Target - hip) - (foot.Path.Lift - foot.Path.Over);
            limit.Bend(leg, parts, goal, away, way, ref solved);
            if (limit.Arriving > 0f)
            {
                // It will stand where it comes down, on the ground: with the leg as it then is.
                LegRotations held = solved;
                Vector3 place = LegSolver.EndOf(leg, parts, solved);
                Aim(leg, parts, carrier, goal with { Chord = place + (away * Math.Max(way - Vec.Dot(away, place), 0f)) }, local, out solved);
                solved.Blend(held, 1f - limit.Arriving, leg.Hinge);
            }

            SetHip(leg, carrier, solved, local);
            SetKnee(leg, solved, local);
        }

        if (bent || goal.Chord != chord)
        {
            solved.Residual = Vec.Distance(LegSolver.EndOf(leg, parts, solved), chord);
        }

        foot.Leg.Hip = hip;
        foot.Leg.Carrier = carrier;
        foot.Leg.Stretch = solved.Stretch;
        foot.Leg.Residual = solved.Residual;
        float down = foot.Plan.Arrived && foot.Taken == 0f ? 1f : limit.Arriving;
        foot.Leg.Astray = down > 0f ? (LegSolver.EndOf(leg, parts, solved) - chord) * down : default;
    }

    /// <summary>How high a foot that is carried over what stands in its way comes below its hip at most, metres above that: closer past it, its leg would whirl about the hip.</summary>
    private static float Underneath(LegRig leg, Vector3 chord)
    {
        float near = NearestPass * leg.FoldedReach;
        return (((chord.X * chord.X) + (chord.Z * chord.Z)) / near) - near;
    }

    /// <summary>Solves hip and knee for a goal and writes them, the hip within its limits.</summary>
    /// <returns>Whether the hip goes as far as it is asked.</returns>
    private bool Aim(LegRig leg, in LegSegments parts, Quaternion carrier, in LegGoal goal, in Pose local, out LegRotations solved)
    {
        LegSolver.Solve(leg, parts, goal.Chord, LegSolver.Side(leg, carrier, goal.Chord, goal.Heading, goal.Lean), goal.Slack, goal.Tolerance, goal.Over, out solved);
        SetHip(leg, carrier, solved, local);
        SetKnee(leg, solved, local);
        if (Bound(local.Rotations, leg.Hip, leg.Limits.Hip, goal.Tolerance) <= goal.Tolerance)
        {
            return true;
        }

        solved.Thigh = Rotation.Multiply(carrier, turns.Of(local, leg.Hip));
        solved.Shank = Rotation.Multiply(solved.Thigh, solved.Knee);
        return false;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void SetHip(LegRig leg, Quaternion carrier, in LegRotations solved, in Pose local) => turns.Set(local, leg.Hip, Rotation.Multiply(Rotation.Inverse(carrier), solved.Thigh));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SetKnee(LegRig leg, in LegRotations solved, in Pose local) => local.Rotations[leg.Knee] = Rotation.Multiply(leg.KneeRest, new Quaternion(solved.KneeHalfSine, 0f, 0f, solved.Knee.W));

    /// <summary>Writes ankle and ball, within their limits.</summary>
    /// <param name="leg">Whose.</param>
    /// <param name="solved">Hip and knee.</param>
    /// <param name="pose">How foot and toes should lie.</param>
    /// <param name="local">The pose.</param>
    /// <param name="far">Tangent of half the turn beyond its fold from which on the ankle is taken for stretched too far: those of feet on the ground are folded however far.</param>
    /// <param name="laid">How far the toes lie as they should all the same where an ankle turns its foot, 0..1, instead of going along with it.</param>
    /// <param name="astray">How far the limit of its ankle takes the ball of a linked leg from where its linkage has it, metres.</param>
    /// <param name="excess">How far ankle and ball are kept from how they should be, about half the angle in radians.</param>
    /// <returns>The turn of the metatarsus from rest.</returns>
    private Quaternion PoseFoot(LegRig leg, in LegRotations solved, in FootPose pose, in Pose local, float far, float laid, out Vector3 astray, out float excess)
    {
        Quaternion metatarsus = pose.Foot;
        if (leg.Traits.Linkage == LegLinkage.Pantograph)
        {
            metatarsus = pose.Fold == 0f ? solved.Thigh : Rotation.Multiply(solved.Thigh, AxisRotation.About(leg.Hinge, FoldOf(leg, pose.Fold, solved.KneeTurn)));
        }

        turns.Set(local, leg.Ankle, Rotation.Multiply(Rotation.Inverse(solved.Shank), metatarsus));
        turns.Set(local, leg.Ball, Rotation.Multiply(Rotation.Inverse(metatarsus), pose.Toes));
        Quaternion asked = local.Rotations[leg.Ankle];
        if (leg.Traits.Linkage == LegLinkage.Foot && !leg.Lateral)
        {
            FoldBack(leg, far, ref local.Rotations[leg.Ankle]);
        }

        // The toes go along with a foot that its ankle turns; those of a flat foot stay on the ground as its heel comes off.
        Bound(local.Rotations, leg.Ankle, leg.Limits.Ankle, 0f);
        Quaternion kept = local.Rotations[leg.Ankle];
        float ankle = asked == kept ? 0f : Chord(asked, kept);
        astray = default;
        if (ankle > 0f)
        {
            Quaternion free = metatarsus;
            metatarsus = Rotation.Multiply(solved.Shank, turns.Of(local, leg.Ankle));
            astray = leg.Traits.Linkage == LegLinkage.Pantograph ? Rotation.Rotate(metatarsus, leg.Metatarsus) - Rotation.Rotate(free, leg.Metatarsus) : astray;
            if (laid > 0f)
            {
                Quaternion toes = Rotation.Multiply(metatarsus, turns.Of(local, leg.Ball));
                toes = laid < 1f ? UnitRotation.Nlerp(toes, pose.Toes, laid) : pose.Toes;
                turns.Set(local, leg.Ball, Rotation.Multiply(Rotation.Inverse(metatarsus), toes));
            }
        }

        excess = Math.Max(ankle, Bound(local.Rotations, leg.Ball, leg.Limits.Ball, 0f));
        return metatarsus;
    }

    /// <summary>Takes from an ankle the fold beyond its limit, seen from that limit: seen from rest one of half a turn and more is bent the other way, or aside.</summary>
    private static void FoldBack(LegRig leg, float far, ref Quaternion ankle)
    {
        Quaternion beyond = Rotation.Multiply(Rotation.Inverse(leg.Limits.AnkleFolded), ankle);
        if (beyond.X * beyond.W * leg.Limits.AnkleFold.X <= 0f || Math.Abs(beyond.X) > far * Math.Abs(beyond.W))
        {
            return;
        }

        float scale = (beyond.W < 0f ? -1f : 1f) / (float)Math.Sqrt((beyond.X * beyond.X) + (beyond.W * beyond.W));
        var fold = new Quaternion(-beyond.X * scale, 0f, 0f, beyond.W * scale);
        ankle = Rotation.Multiply(leg.Limits.AnkleFolded, Rotation.Multiply(beyond, fold));
    }

    /// <summary>Brings a joint back towards its limit; says how far beyond it was, about half the angle in radians.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Bound(Span<Quaternion> rotations, int index, in LocalLimit limit, float tolerance)
    {
        Quaternion turn = rotations[index];
        Quaternion bounded = limit.Clamp(turn);
        if (bounded == turn)
        {
            return 0f;
        }

        float chord = Chord(turn, bounded);
        float kept = tolerance / chord;
        if (kept < 1f)
        {
            rotations[index] = kept > 0f ? UnitRotation.Nlerp(bounded, turn, kept) : bounded;
        }

        return chord;
    }

    /// <summary>Difference of two turns, about half the angle in radians.</summary>
    private static float Chord(Quaternion a, Quaternion b)
    {
        float sign = SimdKernels.Dot(a, b) < 0f ? -1f : 1f;
        float x = a.X - (sign * b.X);
        float y = a.Y - (sign * b.Y);
        float z = a.Z - (sign * b.Z);
        float w = a.W - (sign * b.W);
        return (float)Math.Sqrt((x * x) + (y * y) + (z * z) + (w * w));
    }

    /// <summary>Fold of the metatarsus that the ankle can follow. Bounded here, as an angle: folded by more than half a turn the ankle would seem to be bent the other way.</summary>
    private static float FoldOf(LegRig leg, float fold, float knee)
    {
        AngleRange range = leg.Limits.AnkleRange;
        return knee + Scalar.Clamp(fold - knee, range.Min, range.Max);
    }
}
