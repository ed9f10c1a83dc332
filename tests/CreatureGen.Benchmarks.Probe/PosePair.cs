using System.Numerics;
using CreatureGen.Rigging;
#if EARLIER
using CreatureGen.Animation;
using CreatureGen.Animation.Grounds;
#else
using CreatureGen.Motion;
using CreatureGen.Motion.Grounds;
#endif

namespace CreatureGen.Benchmarks.Probe;

/// <summary>Two poses of one creature on the move, and room for a third.</summary>
internal sealed class PosePair
{
    private readonly Quaternion[][] rotations = new Quaternion[3][];
    private readonly Vector3[][] positions = new Vector3[3][];

    public PosePair(MotionProfile profile)
    {
#if EARLIER
        Skeleton = profile.Creature.Skeleton;
#else
        Skeleton = profile.Subject.Skeleton;
#endif
        Totals = new float[Skeleton.Count];
        var animator = new CreatureAnimator(profile);
        for (int pose = 0; pose < 3; pose++)
        {
            for (int i = 0; i < 10; i++)
            {
                animator.Update(1f / 60f, new MotionInput(1f), FlatGround.Level);
            }

            rotations[pose] = animator.LocalPose.Rotations.ToArray();
            positions[pose] = animator.LocalPose.Positions.ToArray();
        }
    }

    public Skeleton Skeleton { get; }

    public float[] Totals { get; }

    public Pose First => new(rotations[0], positions[0]);

    public Pose Second => new(rotations[1], positions[1]);

    public Pose Result => new(rotations[2], positions[2]);
}
