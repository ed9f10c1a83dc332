using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;

namespace CreatureGen.Tests.Motion.Walking;

/// <summary>A walker in one of its gaits at its most comfortable speed, settled; then watched over two cycles.</summary>
internal sealed class GaitCycle
{
    private const int Rate = 240;

    private readonly int frames;

    public GaitCycle(ulong seed, Gait gait)
        : this(new MotionProfile(Walkers.Any(seed)), gait)
    {
    }

    public GaitCycle(MotionProfile profile, Gait gait)
    {
        Creature = profile.Subject.Creature!;
        Profile = profile;
        Speed = Profile.Gaits!.Speeds.Single(speed => speed.Gait == gait).Comfortable;
        Animator = new CreatureAnimator(Profile);
        Animator.Settings = Animator.Settings with { Walking = WalkingSettings.Default with { Gait = gait } };
        Walkers.Run(Animator, 5f, Rate, new MotionInput(Speed), FlatGround.Level);
        frames = (int)Math.Ceiling(2 * Rate / Animator.Frequency);
    }

    public Creature Creature { get; }

    public MotionProfile Profile { get; }

    public CreatureAnimator Animator { get; }

    public float Speed { get; }

    /// <summary>Goes on for two cycles.</summary>
    public void Watch(Action look)
    {
        for (int i = 0; i < frames; i++)
        {
            Animator.Update(1f / Rate, new MotionInput(Speed), FlatGround.Level);
            look();
        }
    }

    /// <summary>Greatest less least of a number over two cycles.</summary>
    public float Range(Func<float> number)
    {
        float min = float.MaxValue;
        float max = float.MinValue;
        Watch(() =>
        {
            min = Math.Min(min, number());
            max = Math.Max(max, number());
        });
        return max - min;
    }

    /// <summary>Fastest turn of a joint relative to its parent over two cycles, radians per second.</summary>
    public float Fastest(int joint)
    {
        float max = 0f;
        Quaternion before = Animator.LocalPose.Rotations[joint];
        Watch(() =>
        {
            max = Math.Max(max, Rate * (float)MovingPose.Between(before, Animator.LocalPose.Rotations[joint]));
            before = Animator.LocalPose.Rotations[joint];
        });
        return max;
    }

    /// <summary>The first joint of a role.</summary>
    public int Joint(JointRole role) => Enumerable.Range(0, Creature.Skeleton.Count).First(i => Creature.Skeleton.Joints[i].Role == role);

    /// <summary>How far a joint is turned from rest, model space.</summary>
    public Quaternion TurnOf(JointRole role)
    {
        int joint = Joint(role);
        return Quaternion.Normalize(Animator.ModelPose.Rotations[joint] * Quaternion.Inverse(Creature.Skeleton.ModelRotations[joint]));
    }

    /// <summary>Bend of the back, radians: the pitch of the chest seen from the pelvis.</summary>
    public float Flexion()
    {
        Quaternion bend = Quaternion.Inverse(TurnOf(JointRole.Pelvis)) * TurnOf(JointRole.Chest);
        return 2f * MathF.Atan2(bend.X * MathF.Sign(bend.W), MathF.Abs(bend.W));
    }
}
