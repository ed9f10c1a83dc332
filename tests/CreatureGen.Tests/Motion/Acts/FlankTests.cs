using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Metrics;
using CreatureGen.Motion.Subjects;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
using CreatureGen.Tests.Creatures;
using CreatureGen.Tests.Sampling;
using CreatureGen.Tests.Motion.Kept;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class FlankTests
{
    private const float Rate = 60f;

    /// <summary>Necks bend no farther than they do: crests and frills went into the ground by up to .062 of the body's length as these rolled.</summary>
    [Theory]
    [InlineData(24500000UL)]
    [InlineData(22300032UL, Explicit = true)]
    public void Who_rolls_over_with_a_frill_or_a_crest_is_lifted_over_it(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        ActReport report = ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == "Die").Run(profile);
        Assert.InRange(report.Penetration!.Value, 0f, 0.01f);
        Assert.InRange(report.JointSpeed, 0f, 60f);
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade, "Die")]
    [InlineData(BodyPlan.Unguligrade, "Die", Explicit = true)]
    [InlineData(BodyPlan.Columnar, "Die", Explicit = true)]
    [InlineData(BodyPlan.Theropod, "Die")]
    [InlineData(BodyPlan.Unguligrade, "Sleep")]
    [InlineData(BodyPlan.Upright, "Die")]
    [InlineData(BodyPlan.Upright, "Lie", Explicit = true)]
    [InlineData(BodyPlan.Upright, "Sleep")]
    public void Who_dies_or_sleeps_with_its_legs_under_its_body_lies_on_its_flank_and_stands_again(BodyPlan plan, string act)
    {
        List<string> wrong = [];
        for (ulong seed = 1; seed <= 3; seed++)
        {
            var profile = new MotionProfile(Walkers.Of(plan, seed));
            ActAbility ability = profile.Acts.Find(act);
            var lying = new Lying(profile, ability);
            float height = lying.Height;
            float again = lying.HeightAgain();
            if (!(lying.Turned is > 1f and < 2.1f && height < 0.6f && again is > 0.95f and < 1.05f))
            {
                wrong.Add(FormattableString.Invariant($"{seed}: turned by {lying.Turned:0.00}, chest at {height:0.00} of its height, {again:0.00} afterwards"));
            }
        }

        Assert.Empty(wrong);
    }

    /// <summary>Wings at rest are spread, and were held to keep a body off its flanks, on which they are folded: all fliers crouched as they died, as if alive.</summary>
    [Theory]
    [InlineData(22300000UL)]
    [InlineData(22300012UL, Explicit = true)]
    public void Who_has_wings_dies_on_a_folded_one_and_sleeps_on_its_belly(ulong seed)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying }));
        Assert.True(SpreadWings.Of(profile.Subject));
        var dead = new Lying(profile, profile.Acts.Find("Die"));
        Assert.InRange(dead.Turned, 1f, 2.1f);
        Assert.InRange(dead.Height, 0f, 0.75f);
        Assert.InRange(dead.HeightAgain(), 0.95f, 1.05f);
        Assert.InRange(new Lying(profile, profile.Acts.Find("Sleep")).Turned, 0f, 0.8f);
    }

    /// <summary>Of a dozen unselected; those that do not lie too high on their sides, or their horns and frills do not let them onto these.</summary>
    [Fact(Explicit = true)]
    public void Most_of_those_with_wings_die_on_a_flank()
    {
        float[] turned = [.. Enumerable.Range(22300000, 12).Select(seed => new MotionProfile(CreatureGenerator.Generate((ulong)seed, CreatureOptions.Default with { Kind = RequestedKind.Flying })))
            .Where(profile => profile.Legs != null && SpreadWings.Of(profile.Subject)).Select(profile => new Lying(profile, profile.Acts.Find("Die")).Turned)];
        Assert.True(turned.Count(angle => angle is > 1f and < 2.1f) > 0.7f * turned.Length, string.Join(", ", turned));
    }

    /// <summary>They stayed on their legs with their heads up, and looked tired.</summary>
    [Theory]
    [InlineData(BodyPlan.Sprawling)]
    [InlineData(BodyPlan.Hexapod, Explicit = true)]
    [InlineData(BodyPlan.ManyLegged, Explicit = true)]
    public void Who_dies_with_its_legs_out_to_the_sides_lies_on_its_back_with_its_feet_up_and_stands_again(BodyPlan plan)
    {
        List<string> wrong = [];
        int turnedOver = 0;
        for (ulong seed = 1; seed <= 4; seed++)
        {
            var profile = new MotionProfile(Walkers.Of(plan, seed));
            ActAbility ability = profile.Acts.Find("Die");
            if (!ability.Act.Needs.HasFlag(ActNeeds.Back))
            {
                continue;
            }

            turnedOver++;
            var lying = new Lying(profile, ability);
            CreatureAnimator animator = lying.Animator;
            bool feetUp = profile.Legs!.Legs.All(leg => animator.ModelPose.Positions[leg.Ball].Y > animator.ModelPose.Positions[leg.Hip].Y);
            float lowest = profile.Fall.Value.Support.Lowest(animator.Root, animator.ModelPose, Vector3.UnitY, FlatGround.Level) / profile.Fall.Value.Ragdoll.Size;
            float again = lying.HeightAgain();
            if (!(lying.Turned > 2.5f && feetUp && lowest is > -0.02f and < 0.015f && again is > 0.95f and < 1.05f))
            {
                wrong.Add(FormattableString.Invariant($"{seed}: turned by {lying.Turned:0.00}, feet up {feetUp}, {lowest:0.000} of its size above the ground, chest at {again:0.00} of its height afterwards"));
            }
        }

        Assert.Empty(wrong);
        Assert.InRange(turnedOver, 1, 4);
    }

    /// <summary>A hind foot was lifted past its hip as the body went over, and its ball turned by 490 rad/s. What hangs on springs is not posed, and gives way at once where the head presses it to the ground.</summary>
    [Theory]
    [InlineData(9971544UL, "Die")]
    [InlineData(9971544UL, "Sleep")]
    public void No_joint_whirls_as_a_body_goes_over_onto_its_flank(ulong seed, string act) => NoJointWhirls(new MotionProfile(Walkers.Any(seed)), act);

    /// <summary>Hips of an upright body came down so far over its folded legs that these turned over at 860 rad/s.</summary>
    [Theory]
    [InlineData(21200503UL, "Die")]
    [InlineData(21200502UL, "Sleep")]
    [InlineData(21200107UL, "Die", Explicit = true)]
    public void No_joint_of_an_upright_body_whirls_as_it_lies_down_on_its_side(ulong seed, string act) =>
        NoJointWhirls(new MotionProfile(KeptCreatures.Of(seed)), act);

    /// <summary>Feet of legs on their way behind the body were taken below hips that had come down already, and whirled about these at 270 rad/s.</summary>
    [Theory]
    [InlineData(21201002UL, "Lie")]
    [InlineData(21201002UL, "Die")]
    public void No_leg_of_an_upright_body_whirls_as_it_lies_down(ulong seed, string act)
    {
        var profile = new MotionProfile(KeptCreatures.Of(seed));
        Assert.InRange(ActTrial.Of(profile).Single(trial => trial.Ability.Act.Name == act).Run(profile).JointSpeed, 0f, 60f);
    }

    private static void NoJointWhirls(MotionProfile profile, string act)
    {
        const float Fine = 240f;
        ActAbility ability = profile.Acts.Find(act);
        Assert.Contains(ability.Act.Phases.SelectMany(phase => phase.Ends), end => end.Channel == ActChannel.OnFlank && end.Value != 0f);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        animator.Perform(ability);
        HashSet<int> hung = [.. profile.Swinging.SelectMany(chain => chain.Rig.Joints.ToArray())];
        Quaternion[] before = animator.LocalPose.Rotations.ToArray();
        double fastest = 0;
        for (int i = 0; i < Fine * ability.SecondsToLast; i++)
        {
            animator.Update(1f / Fine, default, FlatGround.Level);
            for (int j = 0; j < before.Length; j++)
            {
                double turn = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(before[j]), animator.LocalPose.Rotations[j]));
                fastest = hung.Contains(j) ? fastest : Math.Max(fastest, Fine * turn);
                before[j] = animator.LocalPose.Rotations[j];
            }
        }

        Assert.InRange(fastest, 0, 40);
    }

    /// <summary>Feet come together on the flank. Broad paws went into one another there: 11 % of the triangles crossed.</summary>
    [Fact]
    public void Broad_paws_lie_beside_one_another_on_the_flank()
    {
        const ulong Seed = 7200004;
        var profile = new MotionProfile(GrownCreatures.Of(Seed, SizeOfSeed.In(CreatureOptions.Default with { Kind = RequestedKind.Walking }, Seed)));
        ActAbility sleep = profile.Acts.Find("Sleep");
        Assert.Contains(sleep.Act.Phases.SelectMany(phase => phase.Ends), end => end.Channel == ActChannel.OnFlank && end.Value != 0f);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        animator.Perform(sleep);
        Walkers.Run(animator, sleep.SecondsToLast, Rate, default, FlatGround.Level);
        CreatureMesh mesh = profile.Subject.Mesh;
        var matrices = new Matrix4x4[profile.Subject.Skeleton.Count];
        SkinMatrices.Fill(profile.Subject.Skeleton, animator.ModelPose, matrices);
        var positions = new Vector3[mesh.Positions.Length];
        CpuSkinning.Skin(matrices, mesh.Weights, mesh.Positions, mesh.Normals, positions, new Vector3[positions.Length]);
        Assert.InRange(new CrossingCounter(mesh, mesh.Triangles).Count(positions).All, 0, 0.07 * mesh.Triangles.Length / 3);
    }

    [Fact]
    public void Arms_of_who_dies_on_its_flank_lie_beside_it_and_not_in_the_ground()
    {
        var profile = new MotionProfile(Walkers.Of(BodyPlan.Centaur, 1));
        ActAbility die = profile.Acts.Find("Die");
        Assert.Contains(die.Act.Phases.SelectMany(phase => phase.Ends), end => end.Channel == ActChannel.OnFlank && end.Value != 0f);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        animator.Perform(die);
        Walkers.Run(animator, die.SecondsToLast, Rate, default, FlatGround.Level);
        float lowest = profile.Fall.Value.Support.Lowest(animator.Root, animator.ModelPose, Vector3.UnitY, FlatGround.Level);
        Assert.InRange(lowest / profile.Fall.Value.Ragdoll.Size, -0.02f, 0.01f);
    }

    /// <summary>An ear as deep in the ground as 2.5 or 7 % of the body kept them on their bellies, as if alive.</summary>
    [Theory]
    [InlineData(23200100UL)]
    [InlineData(23200103UL)]
    public void Ears_below_a_head_fold_and_let_a_body_die_on_its_flank(ulong seed)
    {
        var profile = new MotionProfile(KeptCreatures.Of(seed));
        ActAbility die = profile.Acts.Find("Die");
        Assert.Contains(die.Act.Phases.SelectMany(phase => phase.Ends), end => end.Channel == ActChannel.OnFlank && end.Value != 0f);
        var animator = new CreatureAnimator(profile);
        animator.Teleport(animator.Root, FlatGround.Level);
        animator.Perform(die);
        Walkers.Run(animator, die.SecondsToLast + 1f, Rate, default, FlatGround.Level);
        ActBody body = profile.Acts.Body;
        Assert.NotEmpty(body.EarSkins);
        Assert.All(body.EarSkins, ear => Assert.InRange(ear.Skin.Lowest(animator.ModelPose) / body.Size, -0.012f, 1f));
    }

    /// <summary>What is to the left of a joint at rest.</summary>
    private static Vector3 LeftOf(CreatureAnimator animator, int joint)
    {
        Vector3 own = Rotation.Rotate(Rotation.Inverse(animator.Profile.Subject.Skeleton.ModelRotations[joint]), Vector3.UnitX);
        return Rotation.Rotate(animator.ModelPose.Rotations[joint], own);
    }

    /// <summary>Who has performed an act up to where that lasts.</summary>
    private sealed class Lying
    {
        private readonly ActAbility ability;
        private readonly int chest;
        private readonly float stood;

        public Lying(MotionProfile profile, ActAbility ability)
        {
            this.ability = ability;
            Animator = new CreatureAnimator(profile);
            Animator.Teleport(Animator.Root, FlatGround.Level);
            Walkers.Run(Animator, 1f, Rate, default, FlatGround.Level);
            chest = profile.Subject.Skeleton.IndexOf("Chest");
            stood = Animator.ModelPose.Positions[chest].Y;
            Vector3 left = LeftOf(Animator, chest);
            Animator.Perform(ability);
            Walkers.Run(Animator, ability.SecondsToLast, Rate, default, FlatGround.Level);
            Turned = (float)Math.Acos(Scalar.Clamp(Vec.Dot(left, LeftOf(Animator, chest)), -1f, 1f));
        }

        public CreatureAnimator Animator { get; }

        /// <summary>How far the chest has turned, radians.</summary>
        public float Turned { get; }

        /// <summary>How high the chest is, of where it stood.</summary>
        public float Height => Animator.ModelPose.Positions[chest].Y / stood;

        /// <summary>The same once it has gone on.</summary>
        public float HeightAgain()
        {
            Animator.GoOn();
            Walkers.Run(Animator, ability.Seconds - ability.SecondsToLast + 0.5f, Rate, default, FlatGround.Level);
            return Height;
        }
    }
}
