using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Watches an animator along a course.</summary>
internal sealed class CourseRecorder
{
    private readonly CreatureAnimator animator;
    private readonly JointWatch joints;
    private readonly HeadWatch head;
    private readonly RootWatch root;
    private readonly FootingWatch? footing;
    private int frames;
    private double seconds;

    public CourseRecorder(CreatureAnimator animator, CourseSurface surface)
    {
        this.animator = animator;
        joints = new JointWatch(animator.Profile);
        head = new HeadWatch(animator.Profile.Subject.Skeleton);
        root = new RootWatch(animator.Root.Position);
        footing = animator.Profile.Legs == null ? null : new FootingWatch(animator, animator.Profile.Legs, surface);
    }

    /// <summary>Measures an update.</summary>
    /// <param name="dt">Its seconds, above 0.</param>
    public void Record(float dt)
    {
        joints.Record(animator.LocalPose.Rotations, dt);
        head.Record(animator.ModelPose, dt);
        root.Record(animator.Root.Position, dt);
        if (animator.StandsOnFeet)
        {
            footing?.Stand(dt);
        }
        else
        {
            footing?.LeaveGround();
        }

        frames++;
        seconds += dt;
    }

    /// <summary>What was measured so far.</summary>
    public CourseReport Report()
    {
        var report = new CourseReport(frames, (float)seconds, (float)joints.Excess, joints.ExcessJoint, joints.Speed, joints.SpeedJoint, joints.Acceleration, joints.FastJoints, root.Acceleration) { HeadSpeed = head.Speed };
        return footing == null ? report : footing.AddTo(report);
    }

    /// <summary>Where it is now.</summary>
    public RestingPlace Rest()
    {
        Pose model = animator.ModelPose;
        var feet = new Vector3[animator.StandsOnFeet ? animator.FootCount : 0];
        for (int i = 0; i < feet.Length; i++)
        {
            FootReport foot = animator.Foot(i);
            Vector3 ball = animator.Root.ToWorld(model.Positions[foot.Joint]);
            feet[i] = foot.Phase == FootPhase.Stance ? new Vector3(ball.X, foot.Place.Y, ball.Z) : foot.Place;
        }

        return new RestingPlace(animator.Root.Position, feet, animator.Profile.LegLength);
    }
}
