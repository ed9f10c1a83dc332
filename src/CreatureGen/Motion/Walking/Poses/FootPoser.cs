using System;
using System.Numerics;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit.Steps;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Trunk;

namespace CreatureGen.Motion.Walking.Poses;

/// <summary>Turns the state of a foot into a pose of it: along the arc of its swing, rolled from heel to toe, laid onto the ground.</summary>
internal static class FootPoser
{
    /// <summary>Share of a swing's height that is left when the creature hardly moves.</summary>
    private const float MinLift = 0.35f;

    /// <summary>Height at which a foot that an act takes has left the ground wholly, leg lengths.</summary>
    private const float TakenHeight = 0.02f;

    /// <summary>How far up the normal of ground is that counts as level.</summary>
    private const float Level = 0.99999f;

    /// <summary>Poses a foot.</summary>
    /// <param name="leg">Its leg.</param>
    /// <param name="foot">Its state.</param>
    /// <param name="way">What its swing has to clear.</param>
    /// <param name="frame">Where the root is.</param>
    /// <param name="gait">The shape of its step.</param>
    /// <param name="rest">How far it rests on its tip, radians, toes down.</param>
    /// <param name="pose">Receives the pose.</param>
    public static void Pose(LegRig leg, ref Foot foot, SwingClearance way, in RootPlace frame, in GaitNumbers gait, float rest, out FootPose pose)
    {
        Quaternion inverse = Rotation.Inverse(frame.Rotation);
        Vector3 from = frame.ToModel(foot.Plan.From.Position);
        Quaternion heading = Rotation.Multiply(inverse, foot.Plan.From.Heading);
        Vector3 normal = Rotation.Rotate(inverse, foot.Plan.From.Normal);
        foot.Path.Lift = 0f;
        foot.Path.Over = 0f;
        foot.Path.Start = from;
        foot.Path.End = from;
        if (foot.Phase == FootPhase.Swing)
        {
            float u = foot.Swing;
            Vector3 to = frame.ToModel(foot.Plan.To.Position);
            foot.Path.End = to;
            float r = StepPhase.Along(u);
            from += (to - from) * r;
            heading = UnitRotation.Nlerp(heading, Rotation.Multiply(inverse, foot.Plan.To.Heading), r);
            normal = Vec.Normalize(Vec.Lerp(normal, Rotation.Rotate(inverse, foot.Plan.To.Normal), Scalar.Smooth(u)), Vector3.UnitY);
            foot.Path.Over = way.Rise(r);
            foot.Path.Lift = (leg.Traits.Lift * leg.Length * leg.Traits.LiftCurve.At(u) * gait.Lift * (MinLift + ((1f - MinLift) * gait.Activity))) + foot.Path.Over;
        }

        foot.Path.Base = from;
        foot.Path.Planned = heading;
        if (leg.Follows)
        {
            // The foot turns with the leg on the middle of its sole, as far as its ankle does not twist.
            Vector3 before = Rotation.Rotate(heading, leg.SoleMiddle);
            heading = FollowingFoot.Heading(leg, heading, from);
            Vector3 shift = before - Rotation.Rotate(heading, leg.SoleMiddle);
            from += normal.Y < Level ? Rotation.Rotate(UnitRotation.FromTo(Vector3.UnitY, normal), shift) : shift;
        }

        foot.Path.Heading = heading;
        foot.Path.Normal = normal;
        bool swings = foot.Phase == FootPhase.Swing;
        foot.Path.RolledDown = foot.Path.Swung && !swings ? FootRoll.RolledDown(foot, leg) * gait.Roll : 0f;
        foot.Path.Swung = swings;
        FootPosture cycle = FootRoll.At(foot, leg, gait);
        FootPosture posture = foot.Path.Posture.Follow(cycle with { Pitch = cycle.Pitch + rest }, leg.PostureSeconds, gait.Step);
        float pitch = posture.Pitch;
        Quaternion ground = normal.Y < Level ? Rotation.Multiply(UnitRotation.FromTo(Vector3.UnitY, normal), heading) : heading;
        pose.Foot = pitch == 0f ? ground : Rotation.Multiply(ground, AxisRotation.About(leg.RollAxis, pitch));
        Vector3 ball;
        if (leg.FlatFoot)
        {
            float toes = FootRoll.ToePitch(pitch);
            ball = FootRoll.BallAt(leg, foot, toes);
            pose.Toes = toes == 0f ? ground : Rotation.Multiply(ground, AxisRotation.About(leg.RollAxis, toes));
        }
        else
        {
            ball = FootRoll.BallAt(leg, foot, pitch);
            pose.Toes = pose.Foot;
        }

        pose.Ball = from + Rotation.Rotate(ground, ball);
        pose.Ball.Y += foot.Path.Lift;
        if (leg.Traits.Linkage == LegLinkage.Pantograph)
        {
            pose.Fold = posture.Fold;
            pose.Target = pose.Ball;
        }
        else
        {
            pose.Fold = 0f;
            pose.Target = pose.Ball - Rotation.Rotate(pose.Foot, leg.Metatarsus);
        }

        SoleHold.Carry(ref foot, ref pose);
    }

    /// <summary>Takes a foot where an act asks for it.</summary>
    public static void Add(LegRig leg, in FootLayer layer, ref Foot foot, ref FootPose pose)
    {
        Vector3 way = Vec.Lerp(layer.Way, layer.Aim - pose.Ball, layer.AimFraction);
        float raised = Scalar.Smooth(Math.Max(way.Y / leg.Length, layer.AimFraction) / TakenHeight);
        float loose = Scalar.Smooth(layer.Loose / TakenHeight);
        foot.Path.Taken = Math.Max(Math.Max(raised, loose), layer.Carried);
        foot.Path.Aloft = Math.Max(raised, layer.Carried) * (1f - loose);
        foot.Path.Lean = layer.Lean;
        pose.Ball += way;
        if (layer.Pitch != 0f)
        {
            // On the ground the heel of a flat foot rises about its ball; others stand on their toes already.
            Vector3 axis = Rotation.Rotate(foot.Path.Heading, leg.RollAxis);
            pose.Foot = Rotation.Multiply(AxisRotation.About(axis, layer.Pitch * (leg.FlatFoot ? 1f : foot.Taken)), pose.Foot);
            pose.Toes = Rotation.Multiply(AxisRotation.About(axis, layer.Pitch * foot.Taken), pose.Toes);
        }

        pose.Target = leg.Traits.Linkage == LegLinkage.Pantograph ? pose.Ball : pose.Ball - Rotation.Rotate(pose.Foot, leg.Metatarsus);
    }

    /// <summary>Takes a foot of a folded leg along the ground with the trunk that is bent to a side over it, by as much as it stands no longer.</summary>
    public static void Trail(LegRig leg, TrunkChain trunk, float loose, ref Foot foot, ref FootPose pose)
    {
        int slot = leg.TrunkSlot;
        Vector3 ahead = Rotation.Rotate(trunk.Turns[slot], Vector3.UnitZ);
        Quaternion turn = AxisRotation.YawPitchRoll(FastTrigonometry.Of(ahead.X, ahead.Z) * loose, 0f, 0f);
        Vector3 at = Vec.Lerp(trunk.Rest[slot], trunk.Positions[slot], loose) + Rotation.Rotate(turn, pose.Target - trunk.Rest[slot]);
        pose.MoveBy((at - pose.Target) with { Y = 0f });
        pose.Foot = Rotation.Multiply(turn, pose.Foot);
        pose.Toes = Rotation.Multiply(turn, pose.Toes);
        foot.Path.Heading = Rotation.Multiply(turn, foot.Path.Heading);
    }

    /// <summary>Takes a foot along with the raised front of the trunk that its leg hangs on.</summary>
    public static void Carry(LegRig leg, TrunkChain trunk, in FootLayer layer, ref Foot foot, ref FootPose pose)
    {
        // What it is aimed at stays where it is.
        Vector3 aimed = (layer.Aim - trunk.Carry(leg.TrunkSlot, layer.Aim, out Quaternion turn)) * layer.AimFraction;
        float stood = pose.Ball.Y;
        pose.Ball = trunk.Carry(leg.TrunkSlot, pose.Ball, out _) + aimed;
        pose.Target = trunk.Carry(leg.TrunkSlot, pose.Target, out _) + aimed;

        // One that is behind the joint about which the front is raised would go down.
        pose.MoveBy(new Vector3(0f, Math.Max(0f, stood - pose.Ball.Y) * (1f - layer.AimFraction), 0f));
        pose.Foot = Rotation.Multiply(turn, pose.Foot);
        pose.Toes = Rotation.Multiply(turn, pose.Toes);
        foot.Path.Heading = Rotation.Multiply(turn, foot.Path.Heading);
        foot.Path.Normal = Rotation.Rotate(turn, foot.Path.Normal);
    }
}
