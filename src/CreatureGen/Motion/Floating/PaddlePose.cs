using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Poses;
using CreatureGen.Motion.Walking.Trunk;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Floating;

/// <summary>Poses a body that floats: the trunk at the surface, and each foot on an oval under its hip, back and down with its sole spread against the water, forward and up with its toes trailing.</summary>
internal sealed class PaddlePose
{
    /// <summary>Part of a cycle in which a foot goes back.</summary>
    private const double PowerPart = 0.42;

    /// <summary>How far below its hip a foot goes in the mean, parts of how far it stands; how far ahead of that, to and fro, and up and down, leg lengths.</summary>
    private const float Depth = 0.74f;
    private const float LateralDepth = 0.85f;
    private const float ReachingDepth = 0.95f;
    private const float Ahead = 0.1f;
    private const float Sweep = 0.34f;
    private const float LateralSweep = 0.24f;
    private const float Rise = 0.15f;

    /// <summary>Pitch of a foot in the mean, and how much it goes to and fro, radians; and how much later than the foot's way, radians of the cycle.</summary>
    private const float FootPitch = 0.5f;
    private const float FootFlap = 0.65f;
    private const double FootDelay = 0.5;

    /// <summary>How far a metatarsus is folded as the foot comes forward, part of what it is in a step.</summary>
    private const float FoldPart = 0.4f;

    /// <summary>How much less the legs of the inner side go to and fro in the sharpest turn.</summary>
    private const float Steering = 0.6f;

    /// <summary>Rise, roll and pitch of the trunk with its strokes: leg lengths, radians.</summary>
    private const float Heave = 0.012f;
    private const float Roll = 0.035f;
    private const float Rock = 0.02f;

    /// <summary>Bend of the trunk in the sharpest turn, radians, as far as it bends.</summary>
    private const float TurnBend = 0.5f;

    /// <summary>Part of the wave of a sprawler's tail that its trunk makes; part of a cycle by which the tip of a tail is later than its root, and part of its joints' limits that the wave takes up.</summary>
    private const float TrunkPart = 0.25f;
    private const double TailDelay = 0.45;
    private const float TailRoom = 0.5f;

    /// <summary>How far ahead of where they hang arms that paddle are held in the mean, and how far to and fro they go; bend of their elbows, and how much more they bend as they come forward; radians.</summary>
    private const float ArmAhead = 1.25f;
    private const float ArmSweep = 0.55f;
    private const float ElbowBend = 0.3f;
    private const float ElbowFold = 0.5f;

    /// <summary>Joints from its root on in which a tail comes down to the water behind a body that lies ahead.</summary>
    private const int LoweredJoints = 4;

    /// <summary>How far from its bed a foot keeps, leg lengths.</summary>
    private const float BedRoom = 0.04f;

    private readonly FloatProfile profile;
    private readonly LeggedBody body;
    private readonly BodyPlacer placer;
    private readonly LegPoser poser;
    private readonly Foot[] feet;

    public PaddlePose(FloatProfile profile)
    {
        this.profile = profile;
        body = profile.Body;
        placer = new BodyPlacer(body);
        poser = new LegPoser(body, body.Turns);
        feet = new Foot[body.Legs.Length];
    }

    /// <summary>Writes trunk, neck and legs.</summary>
    /// <param name="stroke">The moment.</param>
    /// <param name="place">Where the root is.</param>
    /// <param name="up">Unit, away from the ground.</param>
    /// <param name="bed">What is under the water.</param>
    /// <param name="local">Pose in the parents' space of the body as it stands; receives the joints that move.</param>
    public void Write(in PaddleStroke stroke, in RootPlace place, Vector3 up, IGround bed, in Pose local)
    {
        PlaceTrunk(stroke);
        poser.PoseTrunk(placer, local);
        for (int i = 0; i < feet.Length; i++)
        {
            LegRig leg = body.Legs[i];
            FootPose pose = PoseOf(leg, stroke, profile.LagOf(i), place, up, bed);
            feet[i] = default;
            feet[i].Plan.Phase = FootPhase.Swing;
            feet[i].Plan.Swing = 0.5f;
            feet[i].Path.Base = leg.Home;
            feet[i].Path.Heading = placer.Trunk.Turns[leg.TrunkSlot];
            feet[i].Path.Normal = Vector3.UnitY;
            feet[i].Path.Lift = leg.Length;
            poser.PoseLeg(i, placer, ref feet[i], pose, 0f, 0f, local);
        }

        if (profile.LiesAhead)
        {
            PaddleArms(stroke, local);
            LowerTail(1f - stroke.Reach, local);
        }

        LevelHead(1f - stroke.Reach, local);
        WaveTail(stroke, local);
    }

    private void PlaceTrunk(in PaddleStroke stroke)
    {
        PortableMath.SinCos(PortableMath.Tau * stroke.Phase, out double sine, out double cosine);
        float twice = (float)((cosine * cosine) - (sine * sine));
        float swims = 1f - stroke.Reach;
        float pitch = (-profile.Pitch * swims) + (Rock * stroke.Width * twice);
        Vector3 rest = placer.Trunk.Rest[0] - profile.Middle;
        var plan = new TrunkPlan
        {
            Pelvis = profile.Middle + Rotation.Rotate(AxisRotation.Pitch(pitch), rest) + new Vector3(0f, Heave * body.LegLength * stroke.Width * twice, 0f),
            PelvisPitch = pitch,
            PelvisRoll = Roll * stroke.Width * (float)sine,
            BendYaw = swims * Scalar.Clamp((TurnBend * stroke.Steer) + (body.Sprawls ? TrunkPart * profile.Undulation * stroke.Width * (float)sine : 0f), -body.Bends.Yaw, body.Bends.Yaw),
        };
        placer.Trunk.Flex(plan);
        placer.Trunk.Apply(plan, null);
    }

    private FootPose PoseOf(LegRig leg, in PaddleStroke stroke, float lag, in RootPlace place, Vector3 up, IGround bed)
    {
        double turn = TurnAt(stroke.Phase - lag, out bool back, out double progress);
        PortableMath.SinCos(turn, out double sine, out double cosine);
        float inner = Math.Max(leg.Side == Side.Left ? stroke.Steer : -stroke.Steer, 0f);
        float swims = 1f - stroke.Reach;
        float width = swims * stroke.Width * (1f - (Steering * inner)) * leg.Length;
        Vector3 rest = leg.Home - leg.HipRest;
        float depth = Scalar.Lerp(ReachingDepth, leg.Lateral ? LateralDepth : Depth, swims);
        float sweep = leg.Lateral ? LateralSweep : Sweep;
        var way = new Vector3(rest.X, (rest.Y * depth) + leg.BallHeight - (Rise * width * (float)sine), rest.Z + (Ahead * leg.Length * swims) + (sweep * width * (float)cosine));
        TrunkChain trunk = placer.Trunk;
        Quaternion carrier = trunk.Turns[leg.TrunkSlot];
        Vector3 hip = trunk.Positions[leg.TrunkSlot] + Rotation.Rotate(carrier, leg.HipRest - trunk.Rest[leg.TrunkSlot]);
        Vector3 ball = hip + Rotation.Rotate(carrier, way);
        ball.Y = Math.Max(ball.Y, Bed(ball, place, up, bed) + leg.BallHeight);
        Quaternion turned = leg.Follows ? Rotation.Multiply(carrier, leg.Sweep(leg.HipRest + way)) : carrier;
        float pitch = leg.Lateral ? 0f : swims * (FootPitch - (FootFlap * stroke.Width * (float)PortableMath.Cos(turn - FootDelay)));
        Quaternion foot = Rotation.Multiply(turned, AxisRotation.About(leg.RollAxis, pitch));
        var pose = new FootPose { Ball = ball, Foot = foot, Toes = foot };
        if (leg.Traits.Linkage == LegLinkage.Pantograph)
        {
            pose.Fold = back ? 0f : swims * FoldPart * leg.Traits.Fold * leg.Traits.FoldCurve.At((float)progress);
            pose.Target = ball;
        }
        else
        {
            pose.Target = ball - Rotation.Rotate(foot, leg.Metatarsus);
        }

        return pose;
    }

    /// <summary>Where on its oval a foot or a hand is, radians: 0 ahead, π behind.</summary>
    /// <param name="phase">Its place in its own cycle.</param>
    /// <param name="back">Whether it goes back.</param>
    /// <param name="progress">How far it has come there or forward, 0..1.</param>
    private static double TurnAt(double phase, out bool back, out double progress)
    {
        phase -= Math.Floor(phase);
        back = phase < PowerPart;
        progress = back ? phase / PowerPart : (phase - PowerPart) / (1 - PowerPart);
        return PortableMath.Pi * (back ? progress : 1 + progress);
    }

    /// <summary>Each arm goes with the leg of the other side: back and down stretched, forward with its elbow bent.</summary>
    private void PaddleArms(in PaddleStroke stroke, in Pose local)
    {
        float swims = 1f - stroke.Reach;
        foreach (ArmShape arm in body.Arms)
        {
            PortableMath.SinCos(TurnAt(stroke.Phase - (arm.Side == Side.Left ? 0.5 : 0), out _, out _), out double sine, out double cosine);
            float inner = Math.Max(arm.Side == Side.Left ? stroke.Steer : -stroke.Steer, 0f);
            float ahead = ArmAhead + (ArmSweep * stroke.Width * (1f - (Steering * inner)) * (float)cosine);
            float bend = ElbowBend + (ElbowFold * Math.Max(-(float)sine, 0f));
            Bend(arm.Shoulder, -swims * ahead, local);
            Bend(arm.Elbow, -swims * bend, local);
        }
    }

    /// <summary>The tail takes back the pitch of the trunk, which would raise it into the air.</summary>
    private void LowerTail(float swims, in Pose local)
    {
        int count = Math.Min(body.Tail.Length, LoweredJoints);
        for (int i = 0; i < count; i++)
        {
            Bend(body.Tail[i], swims * profile.Pitch / count, local);
        }
    }

    /// <summary>Pitches a joint as it stands, as far as its limits let it.</summary>
    private void Bend(int joint, float pitch, in Pose local)
    {
        body.Turns.Set(local, joint, Rotation.Multiply(AxisRotation.Pitch(pitch), body.Turns.Of(local, joint)));
        local.Rotations[joint] = SwingTwistLimit.ClampLocal(local.Rotations[joint], body.Skeleton.Joints[joint]);
    }

    /// <summary>Height of the lowest that a foot may come to at a place, model space.</summary>
    private float Bed(Vector3 ball, in RootPlace place, Vector3 up, IGround bed)
    {
        float above = profile.Draught + body.LegLength;
        Vector3 from = place.ToWorld(new Vector3(ball.X, above, ball.Z));
        return bed.Cast(from, -up, 2f * above * place.Scale, out GroundHit hit) ? place.ToModel(hit.Point).Y + (BedRoom * body.LegLength) : float.MinValue;
    }

    /// <summary>The neck takes back the pitch of the trunk, or raises the head out of the water.</summary>
    private void LevelHead(float swims, in Pose local)
    {
        int count = body.Neck.Length;
        Quaternion turn = AxisRotation.Pitch(swims * profile.NeckPitch / Math.Max(count, 1));
        foreach (int joint in body.Neck)
        {
            body.Turns.Set(local, joint, Rotation.Multiply(turn, body.Turns.Of(local, joint)));
            local.Rotations[joint] = SwingTwistLimit.ClampLocal(local.Rotations[joint], body.Skeleton.Joints[joint]);
        }
    }

    /// <summary>A wave runs down the tail.</summary>
    private void WaveTail(in PaddleStroke stroke, in Pose local)
    {
        int count = body.Tail.Length;
        float width = (1f - stroke.Reach) * stroke.Width * profile.Undulation / Math.Max(count, 1);
        for (int i = 0; i < count; i++)
        {
            PortableMath.SinCos(PortableMath.Tau * (stroke.Phase - (TailDelay * (i + 1) / count)), out double sine, out _);
            float yaw = Scalar.Clamp(width * (float)sine, -TailRoom * body.TailLimits[i], TailRoom * body.TailLimits[i]);
            int joint = body.Tail[i];
            body.Turns.Set(local, joint, Rotation.Multiply(AxisRotation.Yaw(yaw), body.Turns.Of(local, joint)));
            local.Rotations[joint] = SwingTwistLimit.ClampLocal(local.Rotations[joint], body.Skeleton.Joints[joint]);
        }
    }
}
