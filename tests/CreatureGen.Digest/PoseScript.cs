using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;

namespace CreatureGen.Digest;

/// <summary>
/// 600 updates in the life of a creature, half of them on level ground and half on rough: it stands, goes at several speeds, turns both ways, backs up, goes sideways, rises and sinks, looks at something,
/// is moved by the game, and stops. Every update is hashed.
/// </summary>
internal sealed class PoseScript
{
    private const int Updates = 600;
    private readonly CreatureAnimator animator;
    private readonly BitHash hash;
    private readonly IGround rough;
    private readonly bool flies;
    private readonly float size;
    private readonly float speed;

    public PoseScript(Creature creature, BitHash hash)
    {
        this.hash = hash;
        animator = new CreatureAnimator(creature);
        flies = creature.Blueprint.Kind == LocomotionKind.Flying;

        // Half of how far its joints reach upward or along, and the speed of something that falls so far.
        foreach (Joint joint in creature.Skeleton.Joints)
        {
            size = MathF.Max(size, 0.5f * MathF.Max(joint.ModelPosition.Y, MathF.Abs(joint.ModelPosition.Z)));
        }

        speed = MathF.Sqrt(2f * 9.81f * size);
        rough = new RoughGround(size, 0.06f * size);
    }

    public void Run()
    {
        for (int i = 0; i < Updates; i++)
        {
            int half = i % (Updates / 2);
            IGround ground = i < Updates / 2 ? FlatGround.Level : rough;
            if (half == 0)
            {
                animator.Teleport(new RootPlace(new Vector3(0.3f * size, 0f, -0.2f * size), Quaternion.Identity, i == 0 ? 1f : 1.25f), ground);
            }

            Set(half);
            float dt = half % 3 == 0 ? 1f / 30f : 1f / 60f;
            if (half is >= 230 and < 250)
            {
                RootPlace root = animator.Root;
                animator.Follow(dt, new RootPlace(root.Position + new Vector3(0.1f * speed * dt, 0f, 0.3f * speed * dt), root.Rotation, root.Scale), ground);
            }
            else
            {
                animator.Update(dt, Input(half), ground);
            }

            Hash();
        }
    }

    private static EscapeTurn Escape(int update) => update is >= 140 and < 160 ? EscapeTurn.Left : EscapeTurn.None;

    private MotionInput Input(int update)
    {
        MotionMedium medium = flies && update is >= 20 and < 200 ? MotionMedium.Air : MotionMedium.Ground;
        return update switch
        {
            < 20 => default,
            < 60 => new MotionInput(0.3f * speed, ClimbRate: 0.1f * speed, Medium: medium),
            < 100 => new MotionInput(0.6f * speed, 0.8f, Medium: medium),
            < 140 => new MotionInput(1.2f * speed, -0.4f, Medium: medium),
            < 170 => new MotionInput(0.5f * speed, Escape: Escape(update), Medium: medium),
            < 190 => new MotionInput(-0.1f * speed, 0.5f, Medium: medium),
            < 230 => new MotionInput(0.2f * speed, Sideways: 0.1f * speed, ClimbRate: -0.1f * speed, Medium: medium),
            _ => default,
        };
    }

    private void Set(int update)
    {
        MotionSettings settings = MotionSettings.Default;
        if (update is >= 100 and < 200)
        {
            settings.Slithering = settings.Slithering with { Gait = SlitherGait.Sidewinding };
            settings.Walking = settings.Walking with { Stride = 0.8f };
            settings.Walking = settings.Walking with { Lift = 1.3f };
        }

        animator.Settings = settings;
        animator.LookAt = update is >= 70 and < 160 ? new Vector3(2f * size, size, 30f * size) : null;
        if (update == 210)
        {
            animator.Rebase(new Vector3(2f * size, 0f, -size));
        }
    }

    private void Hash()
    {
        RootPlace root = animator.Root;
        hash.Add(root.Position);
        hash.Add(root.Rotation);
        hash.Add(root.Scale);
        Pose pose = animator.LocalPose;
        foreach (Quaternion rotation in pose.Rotations)
        {
            hash.Add(rotation);
        }

        foreach (Vector3 position in pose.Positions)
        {
            hash.Add(position);
        }

        foreach (MotionEvent item in animator.Events)
        {
            hash.Add((int)item.Kind);
            hash.Add(item.Foot);
            hash.Add(item.Joint);
            hash.Add(item.Position);
            hash.Add(item.Normal);
            hash.Add(item.Surface);
            hash.Add(item.Speed);
            hash.Add(item.Strength);
            hash.Add(item.SecondsAgo);
        }
    }
}
