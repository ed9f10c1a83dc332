using System.Numerics;
using System;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Data;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Turns values of channels into a layer for trunk and feet, and into turns of all else.</summary>
internal sealed class ActLayer
{
    /// <summary>How far a body on two legs bows for a chest that is let down whole, radians.</summary>
    private const float Bow = 0.9f;

    /// <summary>How far ears and feelers are laid back, and fins spread, radians.</summary>
    private const float EarTurn = 0.8f;
    private const float FeelerTurn = 0.6f;
    private const float FinTurn = 0.7f;

    /// <summary>Part of a back's bend by which folded wings that hang on its front are turned against it: they go along its chord, and stay on a rump that the chest bows away from.</summary>
    private const float WingsAlongChord = 0.7f;

    /// <summary>How high an act holds a foot whose leg is not folded under the body with the others any more, parts of the leg.</summary>
    private const float Unfolded = 0.3f;

    /// <summary>How far feet come to the middle below a body on its flank, parts of the way.</summary>
    private const float Together = 0.7f;

    /// <summary>How far ahead of the lower one the upper leg of an upright body on its side is, parts of the leg, and how far its foot comes down across the middle, parts of the way there.</summary>
    private const float Staggered = 0.25f;
    private const float Across = 1.2f;

    /// <summary>How far a body that rolls over onto its back is over when legs out to the sides are drawn in whole: it would climb over them.</summary>
    public const float DrawnIn = 0.08f;

    /// <summary>How far a body that rolls over is over when its wings are folded whole.</summary>
    private const float WingsIn = 0.5f;

    /// <summary>How far out from their hips feet of a body on its back stay, parts of the leg.</summary>
    private const float Outside = 0.2f;

    /// <summary>How far a raised front is bent up when its feet are off the ground, radians, and how much less each pair behind the foremost does than that, parts.</summary>
    private const float FrontOff = 0.06f;
    private const float BackShare = 0.3f;

    private readonly ActBody body;
    private readonly FoldedLegs folded;

    public ActLayer(ActBody body, FoldedLegs folded)
    {
        this.body = body;
        this.folded = folded;
        Trunk = new BodyLayer(body.Legs?.Legs.Length ?? 0);
    }

    /// <summary>What is asked of trunk and feet.</summary>
    public BodyLayer Trunk { get; }

    /// <summary>How far no foot stands, 0..1: folded legs leave the body to the ground.</summary>
    public float Loose { get; private set; }

    /// <summary>Takes over what another of the same creature asks.</summary>
    public void CopyFrom(ActLayer other)
    {
        Trunk.CopyFrom(other.Trunk);
        Loose = other.Loose;
    }

    /// <summary>Fills the layer for trunk and feet.</summary>
    /// <param name="values">Of the channels.</param>
    /// <param name="side">1 for an act to the left, −1 to the right.</param>
    public void Ask(float[] values, float side)
    {
        float over = Math.Min(Math.Abs(values[(int)ActChannel.OnFlank]), 1f);

        // Who rolls over onto its wings folds them before: over the end of a spread one it would climb.
        Trunk.Wings = values[(int)ActChannel.Wings] - Scalar.Smooth(over / WingsIn);
        if (body.Legs == null)
        {
            return;
        }

        bool onBack = body.LyingSide == LyingSide.Back;
        float tipped = onBack ? Math.Min(over / DrawnIn, 1f) : 0f;
        float unit = body.Unit;
        float fore = values[(int)ActChannel.ForeDown];
        float hind = values[(int)ActChannel.HindDown];
        float belly = body.Legs.BellyHeight;
        float bow = body.Legs.IsBiped ? Bow * Math.Max(fore - hind, 0f) : 0f;
        Trunk.Way = new Vector3(side * values[(int)ActChannel.Aside], values[(int)ActChannel.Up], values[(int)ActChannel.Ahead]) * unit;
        Trunk.Yaw = side * values[(int)ActChannel.Yaw];
        float stretched = body.Build == BodyBuild.Upright ? Scalar.Clamp(values[(int)ActChannel.ForeFold], 0f, 1f) : 0f;
        Trunk.Pitch = values[(int)ActChannel.Pitch] - bow - (Math.Max(stretched, tipped) * folded.Tip);
        Trunk.Roll = side * values[(int)ActChannel.Roll];

        // Folded legs let the chest down to the ground by itself, be it higher than the belly or not.
        float chest = Scalar.Lerp(belly, body.ChestHeight, Scalar.Clamp(values[(int)ActChannel.ForeFold], 0f, 1f));
        Trunk.ForeDown = body.Legs.IsBiped ? hind * belly : fore * chest;
        Trunk.HindDown = hind * belly;
        Trunk.BackPitch = values[(int)ActChannel.BackPitch];
        Trunk.BackSide = side * values[(int)ActChannel.BackSide];
        Trunk.BackTwist = side * values[(int)ActChannel.BackTwist];
        Array.Clear(Trunk.Feet, 0, Trunk.Feet.Length);
        float front = body.Legs.Front.Exists ? Math.Max(values[(int)ActChannel.FrontUp], 0f) : 0f;
        Trunk.FrontPitch = front;
        Trunk.FrontSide = side * values[(int)ActChannel.FrontSide] * Scalar.Smooth(front / FrontOff);
        if (front > 0f)
        {
            CarryFront(front, side < 0f, values);
        }
        else
        {
            Lift(body.ForeFeet, side < 0f, values, ActChannel.ForeFeetUp, ActChannel.ForeFootUp, 1f);
        }

        Lift(body.HindFeet, side < 0f, values, ActChannel.HindFeetUp, ActChannel.HindFootUp, 1f);
        Loose = 1f;
        for (int leg = 0; leg < Trunk.Feet.Length; leg++)
        {
            bool isFore = body.Legs.Rows > 1 && body.Legs.Legs[leg].Row == body.Legs.Rows - 1;
            float lifted = Scalar.Smooth(Trunk.Feet[leg].Way.Y / (Unfolded * body.Legs.Legs[leg].Length));
            float fold = Scalar.Clamp(values[(int)(isFore ? ActChannel.ForeFold : ActChannel.HindFold)], 0f, 1f) * (1f - lifted);
            if (fold > 0f || stretched > 0f)
            {
                folded.AddTo(ref Trunk.Feet[leg], leg, fold * (1f - tipped), stretched, fold * tipped, over);
            }

            // Legs go over with a body that rolls over, and come together so that it lies on its flank, or its back, and not on them.
            bool isLower = (body.Legs.Legs[leg].Side == Side.Left) == (side * values[(int)ActChannel.OnFlank] > 0f);
            Trunk.Feet[leg].Way.X -= Math.Max(over, tipped) * (1f - fold) * (onBack ? BelowHip(leg) : Inward(leg, isLower, stretched));
            Trunk.Feet[leg].Way.Z += isLower ? 0f : over * stretched * Staggered * body.Legs.Legs[leg].Length;
            Trunk.Feet[leg].Loose = Math.Max(Trunk.Feet[leg].Loose, over);
            Loose = Math.Min(Loose, Trunk.Feet[leg].Loose);
        }
    }

    /// <summary>How far a foot of a body on its flank goes to the right of where it stands if it is a left one, metres: the lower ones come to the middle, the upper ones as far as they do not go into these, and off them where paws are broad.</summary>
    /// <param name="leg">Whose foot.</param>
    /// <param name="isLower">Whether it is one of the lower ones.</param>
    /// <param name="stretched">How far the legs are stretched out behind: then the upper one is ahead of the lower one, and comes down before it.</param>
    private float Inward(int leg, bool isLower, float stretched)
    {
        float home = body.Legs!.Legs[leg].Home.X + (stretched * folded.Stretched.Ways[leg].X);
        float together = Together * Math.Abs(home);
        float upper = Math.Min(together, (2f * body.FeetFromMiddle[leg]) - together);
        return Math.Sign(home) * (isLower ? together : Scalar.Lerp(upper, Across * Math.Abs(home), stretched));
    }

    /// <summary>The same of a body on its back: nearly below the hip, and not past it, where a leg out to the side would have to turn round.</summary>
    private float BelowHip(int leg)
    {
        LegRig rig = body.Legs!.Legs[leg];
        float inward = Math.Abs(rig.Home.X) - Math.Abs(body.Skeleton.ModelPositions[rig.Hip].X) - (Outside * rig.Length);
        return Math.Sign(rig.Home.X) * Math.Max(inward, 0f);
    }

    /// <summary>Has feet of folded legs go along the ground on their ways, and not level: on a slope they would be in it, or off it.</summary>
    /// <param name="ground">That the feet stand on.</param>
    public void LayAlong(in ActGround ground)
    {
        foreach (ref FootLayer foot in Trunk.Feet.AsSpan())
        {
            foot.Way.Y -= foot.Loose * ((ground.Normal.X * foot.Way.X) + (ground.Normal.Z * foot.Way.Z)) / ground.Normal.Y;
        }
    }

    /// <summary>Takes a foot to its target.</summary>
    /// <param name="aim">What is brought where; what is no foot is not taken anywhere.</param>
    /// <param name="targetModel">The aim's target, model space.</param>
    /// <param name="fraction">How far on the way, 0..1.</param>
    public void Aim(in ActAim aim, Vector3 targetModel, float fraction)
    {
        if (fraction > 0f && body.Legs != null && aim.Tool is ActTool.ForeFoot or ActTool.HindFoot)
        {
            int foot = ActTools.FootOf(aim.Tool == ActTool.ForeFoot ? body.ForeFeet : body.HindFeet, aim.Mirrored);
            Trunk.Feet[foot].Aim = targetModel;
            Trunk.Feet[foot].AimFraction = Math.Min(fraction, 1f);
        }
    }

    /// <summary>Turns all that no leg carries, on top of the pose.</summary>
    /// <param name="values">Of the channels.</param>
    /// <param name="side">1 for an act to the left, −1 to the right.</param>
    /// <param name="carried">Whether legs carry the trunk at present, which then has its part already.</param>
    /// <param name="local">The pose.</param>
    public void Turn(float[] values, float side, bool carried, in Pose local)
    {
        if (!carried)
        {
            TurnTrunk(values, side, local);
        }

        body.Neck.Turn(body.Turns, side * values[(int)ActChannel.NeckSide], -values[(int)ActChannel.NeckPitch], side * values[(int)ActChannel.NeckTwist], 0, local);
        if (body.Head >= 0)
        {
            TurnJoint(body.Head, AxisRotation.YawPitchRoll(side * values[(int)ActChannel.HeadSide], -values[(int)ActChannel.HeadPitch], side * values[(int)ActChannel.HeadRoll]), local);
        }

        float jaw = JawTurn(values);
        if (jaw != 0f)
        {
            local.Rotations[body.Jaw] = SwingTwistLimit.ClampLocal(Rotation.Multiply(local.Rotations[body.Jaw], AxisRotation.Pitch(jaw)), body.Skeleton.AllJoints[body.Jaw]);
        }

        float ears = values[(int)ActChannel.Ears];
        for (int i = 0; i < body.Ears.Length && ears != 0f; i++)
        {
            TurnJoint(body.Ears[i], AxisRotation.Pitch(-EarTurn * ears), local);
        }

        foreach (TurnedChain feeler in body.Feelers)
        {
            feeler.Turn(body.Turns, 0f, -FeelerTurn * ears, 0f, 0, local);
        }

        body.Tail.Turn(body.Turns, -side * values[(int)ActChannel.TailSide], values[(int)ActChannel.TailPitch], 0f, 0, local);
        body.Tail.Turn(body.Turns, 0f, values[(int)ActChannel.TailCurl], 0f, body.Tail.Count / 2, local);
        TurnArms(values, side, local);
        TurnFins(values[(int)ActChannel.Wings], local);
        if (carried)
        {
            LayWingsAlongBack(values, local);
        }
    }

    /// <summary>How far the jaw is let down from where it is at rest, radians; 0 without one. A mouth shuts no farther than it is at rest: its lips would cut through one another.</summary>
    public float JawTurn(float[] values) => body.Jaw < 0 ? 0f : Math.Max(0f, values[(int)ActChannel.Jaw]) * body.Skeleton.AllJoints[body.Jaw].Limit.SwingX.Max;

    /// <summary>Rolls a body over onto its flank as it lies, legs and all, as a log rolls: it goes aside by what it turns. About a level axis one that lies along a slope would stick out of it on its back.</summary>
    /// <param name="values">Of the channels.</param>
    /// <param name="side">1 for an act to the left, −1 to the right.</param>
    /// <param name="ground">That the feet stand on.</param>
    /// <param name="local">The pose.</param>
    /// <returns>By how much its left side is up, radians.</returns>
    public float RollOver(float[] values, float side, in ActGround ground, in Pose local)
    {
        float turn = -side * values[(int)ActChannel.OnFlank] * folded.Flank;
        if (turn != 0f)
        {
            Quaternion slope = Rotation.FromTo(Vector3.UnitY, ground.Normal);
            Quaternion roll = Rotation.Multiply(slope, Rotation.Multiply(AxisRotation.Roll(turn), Rotation.Inverse(slope)));
            local.Positions[body.Body] -= Rotation.Rotate(slope, new Vector3(turn * body.Depth, 0f, 0f));
            body.Turns.Set(local, body.Body, Rotation.Multiply(roll, body.Turns.Of(local, body.Body)));
        }

        return turn;
    }

    /// <summary>Moves a body that nothing carries, and bends its back.</summary>
    private void TurnTrunk(float[] values, float side, in Pose local)
    {
        float unit = body.Unit;
        Quaternion turn = AxisRotation.YawPitchRoll(side * values[(int)ActChannel.Yaw], -values[(int)ActChannel.Pitch], side * values[(int)ActChannel.Roll]);
        local.Positions[body.Body] += new Vector3(side * values[(int)ActChannel.Aside], values[(int)ActChannel.Up], values[(int)ActChannel.Ahead]) * unit;
        body.Turns.Set(local, body.Body, Rotation.Multiply(turn, body.Turns.Of(local, body.Body)));
        body.Back.Turn(body.Turns, side * values[(int)ActChannel.BackSide], -values[(int)ActChannel.BackPitch], side * values[(int)ActChannel.BackTwist], 0, local);
    }

    private void TurnArms(float[] values, float side, in Pose local)
    {
        foreach (LimbChain arm in body.Arms)
        {
            float own = arm.Side == Side.Left ? 1f : -1f;
            float fraction = own == side ? 1f : 0f;
            float ahead = values[(int)ActChannel.ArmsAhead] + (fraction * values[(int)ActChannel.ArmAhead]);
            float aside = values[(int)ActChannel.ArmsOut] + (fraction * values[(int)ActChannel.ArmOut]);
            float bend = values[(int)ActChannel.ArmsBend] + (fraction * values[(int)ActChannel.ArmBend]);
            if (ahead != 0f || aside != 0f)
            {
                TurnJoint(arm.Joints[1], Rotation.Multiply(AxisRotation.Roll(own * aside), AxisRotation.Pitch(-ahead)), local);
            }

            if (bend != 0f)
            {
                TurnJoint(arm.Joints[2], AxisRotation.Pitch(-bend), local);
            }
        }
    }

    private void LayWingsAlongBack(float[] values, in Pose local)
    {
        float max = body.Legs!.Bends.Pitch;
        float folded = 1f - Scalar.Clamp(values[(int)ActChannel.Wings], 0f, 1f);
        Quaternion turn = AxisRotation.Pitch(WingsAlongChord * folded * Scalar.Clamp(values[(int)ActChannel.BackPitch], -max, max));
        foreach (int wing in body.Wings)
        {
            TurnJoint(wing, turn, local);
        }
    }

    private void TurnFins(float spread, in Pose local)
    {
        for (int i = 0; i < body.Fins.Length && spread != 0f; i++)
        {
            float own = body.Fins[i].Side == Side.Left ? 1f : -1f;
            TurnJoint(body.Fins[i].Joints[0], AxisRotation.Roll(own * FinTurn * spread), local);
        }
    }

    private void TurnJoint(int joint, Quaternion turn, in Pose local)
    {
        if (turn.W != 1f)
        {
            body.Neck.TurnJoint(body.Turns, joint, turn, local);
        }
    }

    /// <summary>Has all feet of a raised front go along with it: those behind the foremost pair do what that does, by turns the left and the right one, and the farther back the less.</summary>
    private void CarryFront(float front, bool mirrored, float[] values)
    {
        float carried = Scalar.Smooth(front / FrontOff);
        for (int i = 0; i < body.FrontPairs.Length; i++)
        {
            (int left, int right) = body.FrontPairs[i];
            Trunk.Feet[left].Carried = Trunk.Feet[right].Carried = carried;
            Lift(body.FrontPairs[i], mirrored != ((i & 1) == 1), values, ActChannel.ForeFeetUp, ActChannel.ForeFootUp, i == 0 ? 1f : carried / (1f + (BackShare * i)));
        }
    }

    /// <summary>Adds what is asked of a pair of feet; its channels are next to one another.</summary>
    private void Lift((int Left, int Right) pair, bool mirrored, float[] values, ActChannel both, ActChannel one, float share)
    {
        Add(pair.Left, mirrored ? 0f : 1f, 1f);
        Add(pair.Right, mirrored ? 1f : 0f, -1f);

        void Add(int foot, float fraction, float outward)
        {
            if (foot >= 0)
            {
                LegRig leg = body.Legs!.Legs[foot];
                float up = values[(int)both] + (fraction * values[(int)one]);
                float ahead = values[(int)both + 1] + (fraction * values[(int)one + 1]);
                float aside = values[(int)both + 2] + (fraction * values[(int)one + 2]);
                Trunk.Feet[foot].Way += new Vector3(outward * aside, Math.Max(up, 0f), ahead) * (share * leg.Length);
                Trunk.Feet[foot].Pitch += share * (values[(int)both + 3] + (fraction * values[(int)one + 3]));
            }
        }
    }
}
