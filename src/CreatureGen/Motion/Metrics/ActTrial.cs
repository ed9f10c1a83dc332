using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Metrics;

/// <summary>An act of a creature that stands on level ground, measured from its beginning until it stands again: at 240 Hz, its skin at 30 Hz. The same trial gives the same figures.</summary>
/// <param name="Ability">What.</param>
public sealed record ActTrial(ActAbility Ability)
{
    private const float Rate = 240f;
    private const int SkinEach = 8;

    /// <summary>Updates from one of the three moments to the next between which a trunk is watched: a twentieth of a second.</summary>
    private const int JoltUpdates = 12;

    /// <summary>Seconds before the act and after it.</summary>
    private const float SettleSeconds = 0.25f;

    /// <summary>A trial of everything that a creature can do.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public static IReadOnlyList<ActTrial> Of(MotionProfile profile) =>
        (profile ?? throw new ArgumentNullException(nameof(profile))).Acts.Possible.Select(ability => new ActTrial(ability)).ToArray();

    /// <summary>Runs the trial.</summary>
    /// <param name="profile">The creature's.</param>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public ActReport Run(MotionProfile profile)
    {
        var animator = new CreatureAnimator(profile ?? throw new ArgumentNullException(nameof(profile)));
        animator.Teleport(animator.Root, FlatGround.Level);
        for (int i = 0; i < (int)(SettleSeconds * Rate); i++)
        {
            animator.Update(1f / Rate, default, FlatGround.Level);
        }

        var skin = new SkinWatch(profile);
        skin.Record(animator.ModelPose);
        float standing = skin.Lowest;
        var joints = new JointWatch(profile);
        var feet = new PlantedFeet(animator);
        var trunk = new TrunkWatch(profile.Subject.Skeleton, JoltUpdates);
        joints.Record(animator.LocalPose.Rotations, 1f / Rate);
        animator.Perform(Ability, Ability.Act.Reaches ? ActTarget.At(Ability.Usual) : default);
        float lasting = Ability.SecondsToLast;
        float seconds = Ability.Seconds + SettleSeconds;
        int frames = (int)(seconds * Rate);
        float? error = null;
        for (int i = 1; i <= frames; i++)
        {
            if (lasting > 0f && i == (int)(lasting * Rate))
            {
                animator.GoOn();
            }

            animator.Update(1f / Rate, default, FlatGround.Level);
            joints.Record(animator.LocalPose.Rotations, 1f / Rate);
            feet.Record();
            trunk.Record(animator.Root, animator.ModelPose);
            if (i % SkinEach == 0)
            {
                skin.Record(animator.ModelPose);
            }

            foreach (ActEvent item in animator.ActEvents)
            {
                error = item.Mark == ActMark.Contact && Ability.Act.Reaches ? Vec.Distance(item.Position, Ability.Usual) / profile.Acts.Body.Size : error;
            }
        }

        bool grounded = profile.Legs != null || profile.Slither != null;
        float sunk = Math.Max(0f, Math.Min(standing, 0f) - skin.Lowest) / profile.Acts.Body.Size;
        return new ActReport(frames, seconds, (float)joints.Excess, joints.ExcessJoint, joints.Speed, joints.SpeedJoint, grounded ? sunk : null, grounded && sunk > 0f ? skin.LowestJoint : -1, error, profile.Legs == null ? null : feet.Worst, trunk.Jolt / profile.Acts.Body.Size);
    }

    /// <summary>Watches how low the skin comes.</summary>
    private sealed class SkinWatch
    {
        private readonly MotionSubject subject;
        private readonly Matrix4x4[] matrices;
        private readonly Vector3[] positions;
        private readonly Vector3[] normals;

        public SkinWatch(MotionProfile profile)
        {
            subject = profile.Subject;
            matrices = new Matrix4x4[subject.Skeleton.Count];
            positions = new Vector3[subject.Mesh.Positions.Length];
            normals = new Vector3[positions.Length];
        }

        /// <summary>Height of the lowest vertex of all poses, metres.</summary>
        public float Lowest { get; private set; } = float.MaxValue;

        /// <summary>The joint that moves it most.</summary>
        public int LowestJoint { get; private set; } = -1;

        public void Record(in Pose model)
        {
            SkinMatrices.Fill(subject.Skeleton, model, matrices);
            CpuSkinning.Skin(matrices, subject.Mesh.Weights, subject.Mesh.Positions, subject.Mesh.Normals, positions, normals);
            for (int v = 0; v < positions.Length; v++)
            {
                if (positions[v].Y < Lowest)
                {
                    Lowest = positions[v].Y;
                    LowestJoint = subject.Mesh.Weights[v].Joint0;
                }
            }
        }
    }

    /// <summary>Watches how far planted feet go: the ball or the middle of the sole, whichever moves less, so that rolling and turning are no slip.</summary>
    private sealed class PlantedFeet
    {
        private readonly CreatureAnimator animator;
        private readonly (Vector3 Ball, Vector3 Sole)?[] stood;

        public PlantedFeet(CreatureAnimator animator)
        {
            this.animator = animator;
            stood = new (Vector3, Vector3)?[animator.FootCount];
        }

        /// <summary>Leg lengths.</summary>
        public float Worst { get; private set; }

        public void Record()
        {
            for (int foot = 0; foot < stood.Length; foot++)
            {
                if (animator.Foot(foot).Phase != FootPhase.Stance)
                {
                    stood[foot] = null;
                    continue;
                }

                LegRig leg = animator.Profile.Legs!.Legs[foot];
                Pose model = animator.ModelPose;
                Vector3 ball = model.Positions[leg.Ball];
                Vector3 sole = SoleMiddle.Of(leg, animator.Profile.Subject.Skeleton, model);
                stood[foot] ??= (ball, sole);
                (Vector3 ballBefore, Vector3 soleBefore) = stood[foot]!.Value;
                Worst = Math.Max(Worst, Math.Min(Vec.Distance(ball, ballBefore), Vec.Distance(sole, soleBefore)) / leg.Length);
            }
        }
    }
}
