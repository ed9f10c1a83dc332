using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Motion.Toolkit;

public sealed class SteppingLegsTests
{
    [Fact]
    public void Legs_are_found_by_names_from_the_front_in_diagonal_groups_and_arms_are_none()
    {
        SteppingLegs legs = SteppingLegs.Of(Figure(2));
        Assert.Equal(4, legs.Count);
        Assert.Equal([0, 1, 1, 0], legs.Groups.ToArray());
        Assert.Equal(0.8f, legs.Length, 3);
        Assert.Equal(2, SteppingLegs.Of(Figure(1)).Count);
        Assert.Contains("no joint is a hip", Assert.Throws<ArgumentException>(() => SteppingLegs.Of(MovingPose.Chain(3, 1f, JointLimit.Free))).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Feet_stand_still_in_the_world_while_the_body_walks_over_them()
    {
        Skeleton skeleton = Figure(2);
        SteppingLegs legs = SteppingLegs.Of(skeleton);
        var homes = new Vector3[legs.Count];
        legs.FillHomes(RootPlace.Identity, homes);
        SteppingFoot[] feet = Array.ConvertAll(homes, home => new SteppingFoot(home));
        int turn = -1;
        int steps = 0;
        float worst = 0f;
        MovingPose pose = new(skeleton);
        for (int i = 0; i < 300; i++)
        {
            var place = new RootPlace(new Vector3(0f, -0.05f, i / 120f), Quaternion.Identity);
            legs.FillHomes(new RootPlace(new Vector3(0f, 0f, i / 120f), Quaternion.Identity), homes);
            bool[] stepped = Array.ConvertAll(feet, foot => foot.IsStepping);
            LegStepper.Update(feet, legs.Groups, homes, new LegStepSettings(0.15f, 0.15f), FlatGround.Level, Vector3.UnitY, 1f / 60f, ref turn);
            pose = new MovingPose(skeleton);
            legs.Apply(feet, place, pose.Local, pose.Model);
            for (int k = 0; k < feet.Length; k++)
            {
                steps += feet[k].IsStepping && !stepped[k] ? 1 : 0;
            }

            for (int joint = 0; joint < skeleton.Count; joint++)
            {
                if (skeleton.Joints[joint].Role == JointRole.Ankle && skeleton.Joints[joint].ModelPosition.Y < 0.2f)
                {
                    // An ankle is above its foot by its height at rest.
                    float nearest = float.MaxValue;
                    foreach (SteppingFoot foot in feet)
                    {
                        nearest = Math.Min(nearest, Vec.Distance(place.ToWorld(pose.ModelPositions[joint]), foot.Position + new Vector3(0f, skeleton.Joints[joint].ModelPosition.Y, 0f)));
                    }

                    worst = Math.Max(worst, nearest);
                }
            }
        }

        Assert.InRange(steps, 20, 120);
        Assert.True(worst < 0.03f, $"{worst}");
    }

    /// <summary>A figure of pairs of legs and a pair of arms, as another program names them.</summary>
    private static Skeleton Figure(int pairs)
    {
        var joints = new List<JointPlacement>();
        void Add(string name, int parent, Vector3 at) => joints.Add(new JointPlacement(name, parent, Quaternion.Identity, at) { Role = JointNames.RoleOf(name), Side = JointNames.SideOf(name) });
        Add("rig:Hips", -1, new Vector3(0f, 0.9f, 0f));
        Add("rig:Spine", 0, new Vector3(0f, 0.3f, 0f));
        foreach ((string side, float x) in new[] { ("Left", 1f), ("Right", -1f) })
        {
            for (int pair = 0; pair < pairs; pair++)
            {
                Add($"rig:{side}UpLeg{pair}", 0, new Vector3(0.1f * x, 0f, -0.6f * pair));
                Add($"rig:{side}Leg{pair}", joints.Count - 1, new Vector3(0f, -0.4f, 0f));
                Add($"rig:{side}Foot{pair}", joints.Count - 1, new Vector3(0f, -0.4f, 0f));
            }

            Add($"rig:{side}Arm", 1, new Vector3(0.2f * x, 0.2f, 0f));
            Add($"rig:{side}ForeArm", joints.Count - 1, new Vector3(0.3f * x, 0f, 0f));
            Add($"rig:{side}Hand", joints.Count - 1, new Vector3(0.25f * x, 0f, 0f));
        }

        return Skeleton.Build(joints);
    }
}
