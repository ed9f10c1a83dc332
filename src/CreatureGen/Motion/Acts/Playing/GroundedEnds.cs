using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Keeps what hangs on the trunk of a body that acts out of the ground, before the whole body has to: neck and head, jaw, tail, feelers and arms; and lays along it what a crawler lets down.</summary>
internal sealed class GroundedEnds
{
    /// <summary>How often arms, jaw and head are brought out of the ground, and neck, tail and feelers, which go deeper, and by how much at most, radians: a turn that is spread over a chain raises its end about half as far.</summary>
    private const int ClearingRounds = 3;
    private const int FeelerRounds = 6;
    private const float MaxCleared = 0.5f;

    /// <summary>How quickly a neck or a head is raised or let down at most, radians per second: as a body rolls over, what touches the ground changes from one moment to the next.</summary>
    private const float FastestRaise = 25f;

    /// <summary>How far a body is over, radians, from which on it lies on its flank: arms come out of the ground by another way there.</summary>
    private const float Flanked = 0.6f;

    /// <summary>How far each joint that a crawler lays down points below level, radians, as far as its skin lets it: it grows thinner to its head.</summary>
    private const float Sinking = 0.35f;

    private readonly ActBody body;

    /// <summary>The way by which each arm is kept out of the ground: −1 ahead, 1 back, 0 where it is not in it.</summary>
    private readonly float[] armWays;

    /// <summary>How far the first neck and its head were raised last, and those beside it, radians; NaN where nothing was before.</summary>
    private readonly float[] raised;

    /// <summary>How far each joint that a crawler lays down was turned up last, radians; NaN where none was laid down before.</summary>
    private readonly float[] laid;

    /// <summary>How far these may go on from there, radians: as far as there is need until time goes on.</summary>
    private float step = float.PositiveInfinity;

    public GroundedEnds(ActBody body)
    {
        this.body = body;
        armWays = new float[body.Arms.Length];
        raised = new float[2 + (2 * body.FurtherHeads.Length)];
        laid = new float[body.Bearers.Length];
        Forget();
    }

    /// <summary>Takes over what another of the same creature knows.</summary>
    public void CopyFrom(GroundedEnds other)
    {
        other.armWays.CopyTo(armWays, 0);
        other.raised.CopyTo(raised, 0);
        other.laid.CopyTo(laid, 0);
        step = other.step;
    }

    /// <summary>Goes on in time.</summary>
    public void Advance(float dt) => step = FastestRaise * dt;

    /// <summary>Forgets by which way arms came out of the ground, and how far heads were raised.</summary>
    public void Forget()
    {
        Array.Clear(armWays, 0, armWays.Length);
        Array.Fill(raised, float.NaN);
        Array.Fill(laid, float.NaN);
    }

    /// <summary>Lays along the ground what a crawler carries raised, joint after joint from the trunk, each down onto its own skin; the head as level as it is at rest.</summary>
    /// <param name="ground">That it lies on.</param>
    /// <param name="fraction">How far on the way there, 0..1.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public void LayDown(in ActGround ground, float fraction, in Pose local, in Pose model)
    {
        if (fraction <= 0f)
        {
            Array.Fill(laid, float.NaN);
            return;
        }

        for (int i = 0; i < body.Bearers.Length; i++)
        {
            int joint = body.Bearers[i];
            Vector3 along = body.Skeleton.Joints[joint].Along;
            float goal = joint == body.Head ? Elevation(Rotation.Rotate(body.Skeleton.ModelRotations[joint], along)) : -Sinking;
            Quaternion carried = local.Rotations[joint];
            float total = fraction * (goal - Elevation(Rotation.Rotate(model.Rotations[joint], along)));
            TurnUp(joint, total, local, model);
            for (int round = 0; round < ClearingRounds; round++)
            {
                float raise = Math.Min(body.BearerSkins[i].Raise(ground, model.Positions[joint], model), MaxCleared);
                total += raise;
                TurnUp(joint, raise, local, model);
            }

            // What of its skin touches the ground changes from one moment to the next, and a joint makes good what all those before it have turned. Turned on from where a limit held it, it would jump.
            float gentle = float.IsNaN(laid[i]) ? total : Math.Min(Math.Max(total, laid[i] - step), laid[i] + step);
            if (gentle != total)
            {
                local.Rotations[joint] = carried;
                Turn(joint, AxisRotation.Pitch(-gentle), local, model);
            }

            laid[i] = gentle;
        }
    }

    /// <summary>Raises the neck where it or the head would be in the ground, and where that is not enough, the head on it.</summary>
    /// <param name="ground">That it may be in.</param>
    /// <param name="over">By how much the body's left side is up, radians.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public void KeepHead(in ActGround ground, float over, in Pose local, in Pose model)
    {
        KeepBorne(ground, body.Neck, body.HeadSkin, FeelerRounds, over, ref raised[0], local, model);
        KeepBorne(ground, body.HeadChain, body.FaceSkin, ClearingRounds, over, ref raised[1], local, model);
    }

    /// <summary>Raises the other heads of a body that has more than one, as the first.</summary>
    /// <param name="ground">That they may be in.</param>
    /// <param name="over">By how much the body's left side is up, radians.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public void KeepFurtherHeads(in ActGround ground, float over, in Pose local, in Pose model)
    {
        for (int i = 0; i < body.FurtherHeads.Length; i++)
        {
            FurtherHead further = body.FurtherHeads[i];
            KeepBorne(ground, further.Neck, further.Skin, FeelerRounds, over, ref raised[2 + (2 * i)], local, model);
            KeepBorne(ground, further.Head, further.Face, FeelerRounds, over, ref raised[3 + (2 * i)], local, model);
        }
    }

    /// <summary>Raises the tail.</summary>
    public void KeepTail(in ActGround ground, float over, in Pose local, in Pose model) => Keep(ground, body.Tail, body.TailSkin, 1f, FeelerRounds, over, local, model);

    /// <summary>Raises feelers, and what points back as tails do.</summary>
    public void KeepFeelers(in ActGround ground, float over, in Pose local, in Pose model)
    {
        for (int i = 0; i < body.Feelers.Length; i++)
        {
            Keep(ground, body.Feelers[i], body.FeelerSkins[i], -1f, FeelerRounds, over, local, model);
        }

        for (int i = 0; i < body.Trains.Length; i++)
        {
            Keep(ground, body.Trains[i], body.TrainSkins[i], 1f, FeelerRounds, over, local, model);
        }
    }

    /// <summary>Swings arms out of the ground.</summary>
    /// <param name="ground">That they may be in.</param>
    /// <param name="over">By how much the body's left side is up, radians.</param>
    /// <param name="comesDown">Whether the body comes down on them.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public void KeepArms(in ActGround ground, float over, bool comesDown, in Pose local, in Pose model)
    {
        for (int i = 0; i < body.Arms.Length; i++)
        {
            KeepArm(ground, over, comesDown, body.Arms[i].Joints[1], body.ArmSkins[i], ref armWays[i], local, model);
        }
    }

    /// <summary>Opens a mouth no farther than the ground below it lets the jaw come down.</summary>
    /// <param name="ground">That it may be in.</param>
    /// <param name="open">How far it is open, radians.</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space.</param>
    public void KeepJaw(in ActGround ground, float open, in Pose local, in Pose model)
    {
        for (int round = 0; round < ClearingRounds && open > 0f; round++)
        {
            float raise = body.JawSkin.Raise(ground, model.Positions[body.Jaw], model);
            if (raise == 0f)
            {
                return;
            }

            float shut = Math.Min(raise, open);
            open -= shut;
            TurnUp(body.Jaw, shut, local, model);
        }
    }

    /// <summary>
    /// Swings an arm that would be in the ground out of it by the way that was the shorter one as it came there: it does not change its mind. One of a body that comes down on it goes
    /// ahead, where there is room for it.
    /// </summary>
    private void KeepArm(in ActGround ground, float over, bool comesDown, int shoulder, BonePoints skin, ref float way, in Pose local, in Pose model)
    {
        // Beside a body on its flank it lies on the ground, and up is to the side.
        float lying = Scalar.Smooth(Math.Abs(over) / Flanked);
        for (int round = 0; round < ClearingRounds && lying < 1f; round++)
        {
            (float ahead, float back) = skin.Swing(ground, model.Positions[shoulder], model);
            if (ahead == 0f)
            {
                way = round == 0 ? 0f : way;
                break;
            }

            way = comesDown ? -1f : way != 0f ? way : ahead <= back ? -1f : 1f;
            Turn(shoulder, AxisRotation.Pitch((1f - lying) * way * Math.Min(way < 0f ? ahead : back, MaxCleared)), local, model);
        }

        for (int round = 0; round < ClearingRounds && lying > 0f; round++)
        {
            float raise = lying * Math.Min(skin.Raise(ground, model.Positions[shoulder], model), MaxCleared);
            Turn(shoulder, AxisRotation.Roll(over > 0f ? raise : -raise), local, model);
        }
    }

    /// <summary>Raises what would be in the ground, as seen from the root, by no more than there may be.</summary>
    /// <returns>By how much, radians.</returns>
    private float Keep(in ActGround ground, TurnedChain chain, BonePoints skin, float sign, int rounds, float over, in Pose local, in Pose model, float most = float.PositiveInfinity)
    {
        float total = 0f;
        for (int round = 0; round < rounds && chain.Count > 0 && total < most; round++)
        {
            float raise = skin.Raise(ground, model.Positions[chain.Joints[0]], model);
            if (raise == 0f)
            {
                break;
            }

            raise = Math.Min(Math.Min(raise, MaxCleared), most - total);
            total += raise;
            TurnChain(chain, sign * raise, over, local, model);
        }

        return total;
    }

    /// <summary>Raises a neck or a head that would be in the ground, and lets it down again, without a jump.</summary>
    private void KeepBorne(in ActGround ground, TurnedChain chain, BonePoints skin, int rounds, float over, ref float before, in Pose local, in Pose model)
    {
        bool goesOn = !float.IsNaN(before);
        float total = Keep(ground, chain, skin, -1f, rounds, over, local, model, goesOn ? before + step : float.PositiveInfinity);
        float least = goesOn ? before - step : 0f;
        if (total < least)
        {
            TurnChain(chain, total - least, over, local, model);
        }

        before = Math.Max(total, least);
    }

    /// <summary>Turns a chain up by a negative angle, down by another: up is to the side of a body that lies on its flank.</summary>
    private void TurnChain(TurnedChain chain, float turn, float over, in Pose local, in Pose model)
    {
        FastTrigonometry.SinCos(over, out float sine, out float cosine);
        chain.Turn(body.Turns, -turn * sine, turn * cosine, 0f, 0, local);
        Subtree.LocalToModel(body.Skeleton, chain.Joints[0], local, model);
    }

    private void TurnUp(int joint, float angle, in Pose local, in Pose model)
    {
        if (angle != 0f)
        {
            Turn(joint, AxisRotation.Pitch(-angle), local, model);
        }
    }

    private void Turn(int joint, Quaternion turn, in Pose local, in Pose model)
    {
        body.Neck.TurnJoint(body.Turns, joint, turn, local);
        Subtree.LocalToModel(body.Skeleton, joint, local, model);
    }

    private static float Elevation(Vector3 way) => FastTrigonometry.Of(way.Y, (float)Math.Sqrt((way.X * way.X) + (way.Z * way.Z)));
}
