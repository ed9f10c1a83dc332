using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Motion;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Motion.Subjects;

/// <summary>What bodies from elsewhere know of their skin and of the joints of their faces: a person of tubes, one around each bone.</summary>
public sealed class RiggedSkinTests
{
    private const float Thickness = 0.07f;

    private static readonly FlatGround ground = new(Vector3.Zero, Vector3.UnitY);

    [Fact]
    public void The_ground_is_where_the_skin_of_the_feet_is_lowest()
    {
        Skeleton person = Person();
        SkinnedMesh skin = SkinOf(person);
        float sole = skin.Positions.ToArray().Min(place => place.Y);
        Assert.Equal(sole, new RiggedBody(person, skin: skin).Ground, 1e-6f);
        Assert.Equal(-0.2f, new RiggedBody(person, -0.2f, skin: skin).Ground);
        Assert.NotEqual(sole, new RiggedBody(person).Ground, 1e-3f);
    }

    [Fact]
    public void It_moves_on_its_skin_neither_above_the_ground_nor_in_it()
    {
        var walk = new Walk(Person());
        float height = walk.Body.Subject.Skeleton.ModelPositions.ToArray().Max(place => place.Y);
        for (int i = 0; i < 240; i++)
        {
            walk.Step(1.3f);
            Assert.InRange(walk.Lowest(), -0.01f * height, 0.01f * height);
        }
    }

    [Fact]
    public void Limp_it_lies_on_its_skin_and_gets_up()
    {
        var walk = new Walk(Person());
        walk.Step(0f);
        walk.Animator.GoLimp();
        for (int i = 0; i < 240; i++)
        {
            walk.Step(0f);
        }

        Assert.InRange(walk.Lowest(), -0.6f * Thickness, 0.3f * Thickness);
        walk.Animator.GetUp();
        for (int i = 0; i < 300; i++)
        {
            walk.Step(0f);
        }

        Assert.InRange(walk.Lowest(), -0.01f, 0.01f);
    }

    [Fact]
    public void Its_bones_are_as_thick_and_its_mass_as_large_as_its_skin()
    {
        Skeleton person = Person();
        MotionSubject thin = new RiggedBody(person, skin: SkinOf(person, 0.04f)).Subject;
        MotionSubject thick = new RiggedBody(person, skin: SkinOf(person, 0.08f)).Subject;
        Assert.All(Shins(thin), bone => Assert.InRange(bone.Radius, 0.035f, 0.045f));
        Assert.All(Shins(thick), bone => Assert.InRange(bone.Radius, 0.07f, 0.09f));
        Assert.InRange(thick.Mass.Mass / thin.Mass.Mass, 3f, 6f);
        Assert.Equal(70f, new RiggedBody(person, mass: 70f, skin: SkinOf(person)).Subject.Mass.Mass);

        static CapsuleCollider[] Shins(MotionSubject subject) => [.. subject.Bones.Where(bone => subject.Skeleton.Joints[bone.Joint].Role == JointRole.Knee && subject.Skeleton.Joints[bone.Joint].Name.StartsWith("Leg", StringComparison.Ordinal))];
    }

    [Fact]
    public void A_bone_that_skin_follows_in_one_place_alone_is_a_thin_one_along_its_length()
    {
        Skeleton person = Person();
        SkinnedMesh skin = SkinOf(person);
        Vector3[] positions = skin.Positions.ToArray();
        int thigh = person.IndexOf("LeftUpLeg");
        Array.Fill(positions, person.ModelPositions[person.IndexOf("LeftLeg")], Array.FindIndex(skin.Weights.ToArray(), one => one.Joint0 == thigh), 24);
        MotionSubject subject = new RiggedBody(person, skin: new SkinnedMesh(positions, skin.Normals.ToArray(), skin.Weights.ToArray(), skin.Triangles.ToArray())).Subject;
        CapsuleCollider bone = subject.Bones.Single(one => subject.Skeleton.Joints[one.Joint].Name == "Leg_L1_Hip");
        Assert.InRange(bone.Radius, 0.015f, 0.025f);
        Assert.Equal(0.45f, Vector3.Distance(bone.Start, bone.End), 0.01f);
    }

    [Fact]
    public void Its_jaw_opens_its_eyes_look_and_its_ears_flick()
    {
        var walk = new Walk(Person());
        int jaw = walk.Body.Skeleton.IndexOf("Jaw"), eye = walk.Body.Skeleton.IndexOf("RightEye"), ear = walk.Body.Skeleton.IndexOf("LeftEar");
        for (int i = 0; i < 30; i++)
        {
            walk.Step(0f);
        }

        walk.Animator.LookAt = new Vector3(-6f, 1.6f, 2f);
        float turned = 0f, flicked = 0f;
        for (int i = 0; i < 1200; i++)
        {
            walk.Step(0f);
            turned = Math.Max(turned, walk.TurnOf(eye));
            flicked = Math.Max(flicked, walk.TurnOf(ear));
        }

        walk.Animator.LookAt = null;
        Assert.InRange(turned, 0.05f, 0.8f);
        Assert.InRange(flicked, 0.05f, 1.5f);
        Assert.InRange(walk.TurnOf(jaw), 0f, 0.02f);
        Assert.Equal(ActStatus.Started, walk.Animator.Perform("Bite").Status);
        float open = 0f;
        for (int i = 0; i < 90; i++)
        {
            walk.Step(0f);
            open = Math.Max(open, walk.TurnOf(jaw));
        }

        Assert.InRange(open, 0.2f, 1.2f);
    }

    [Fact]
    public void A_skin_of_other_joints_is_refused()
    {
        Skeleton person = Person();
        SkinnedMesh skin = SkinOf(person);
        SkinWeights[] wrong = Array.ConvertAll(skin.Weights.ToArray(), _ => new SkinWeights(person.Count, 0, 0, 0, Vector4.UnitX));
        string refusal = Assert.Throws<ArgumentException>(() => new RiggedBody(person, skin: new SkinnedMesh(skin.Positions.ToArray(), skin.Normals.ToArray(), wrong, skin.Triangles.ToArray()))).Message;
        Assert.Contains($"follow joint {person.Count}; expected 0..{person.Count - 1}", refusal, StringComparison.Ordinal);
    }

    /// <summary>A tube around the bone from each joint to the next, and one ahead of what ends.</summary>
    private static SkinnedMesh SkinOf(Skeleton skeleton, float thickness = Thickness)
    {
        var positions = new List<Vector3>();
        var weights = new List<SkinWeights>();
        var triangles = new List<int>();
        for (int joint = 0; joint < skeleton.Count; joint++)
        {
            JointRole role = skeleton.Joints[joint].Role;
            int next = Enumerable.Range(joint, skeleton.Count - joint).FirstOrDefault(child => skeleton.Parents[child] == joint && skeleton.Joints[child].Role is not (JointRole.Hip or JointRole.Jaw or JointRole.Eye or JointRole.Ear), -1);
            if (role is not (JointRole.Jaw or JointRole.Eye or JointRole.Ear or JointRole.End))
            {
                Tube(joint, skeleton.ModelPositions[joint], next < 0 ? skeleton.ModelPositions[joint] + new Vector3(0f, 0f, 0.1f) : skeleton.ModelPositions[next]);
            }
        }

        return new SkinnedMesh(positions.ToArray(), Enumerable.Repeat(Vector3.UnitY, positions.Count).ToArray(), weights.ToArray(), triangles.ToArray());

        void Tube(int joint, Vector3 from, Vector3 to)
        {
            Vector3 along = Vector3.Normalize(to - from);
            Vector3 across = Vector3.Normalize(Vector3.Cross(along, MathF.Abs(along.X) > 0.5f ? Vector3.UnitY : Vector3.UnitX));
            Vector3 beside = Vector3.Cross(along, across);
            int first = positions.Count;
            for (int k = 0; k < 24; k++)
            {
                float turn = MathF.PI * (k % 8) / 4f;
                positions.Add(Vector3.Lerp(from, to, k / 8 / 2f) + (thickness * ((MathF.Cos(turn) * across) + (MathF.Sin(turn) * beside))));
                weights.Add(new SkinWeights(joint, 0, 0, 0, Vector4.UnitX));
            }

            triangles.AddRange([first, first + 1, first + 8]);
        }
    }

    private static Skeleton Person()
    {
        List<JointPlacement> joints =
        [
            Joint("Hips", -1, 0f, 0.98f, 0f), Joint("Spine", 0, 0f, 0.12f, 0f), Joint("Spine1", 1, 0f, 0.2f, 0f),
            Joint("Neck", 2, 0f, 0.22f, 0f), Joint("Head", 3, 0f, 0.1f, 0.02f), Joint("HeadTop_End", 4, 0f, 0.2f, 0f),
            Joint("Jaw", 4, 0f, 0.02f, 0.03f), Joint("LeftEye", 4, 0.03f, 0.08f, 0.08f), Joint("RightEye", 4, -0.03f, 0.08f, 0.08f),
            Joint("LeftEar", 4, 0.08f, 0.12f, 0f), Joint("LeftEarTip_End", 9, 0.02f, 0.08f, 0f), Joint("RightEar", 4, -0.08f, 0.12f, 0f), Joint("RightEarTip_End", 11, -0.02f, 0.08f, 0f),
        ];
        foreach ((string side, float x) in new[] { ("Left", 1f), ("Right", -1f) })
        {
            int first = joints.Count;
            joints.AddRange([Joint(side + "UpLeg", 0, 0.1f * x, -0.04f, 0f), Joint(side + "Leg", first, 0f, -0.45f, 0.01f), Joint(side + "Foot", first + 1, 0f, -0.40f, -0.02f), Joint(side + "ToeBase", first + 2, 0f, -0.05f, 0.15f)]);
            joints.AddRange([Joint(side + "Arm", 2, 0.19f * x, 0.16f, 0f), Joint(side + "ForeArm", first + 4, 0.28f * x, 0f, 0f), Joint(side + "Hand", first + 5, 0.25f * x, 0f, 0f)]);
        }

        return Skeleton.Build(joints);

        static JointPlacement Joint(string name, int parent, float x, float y, float z) => new(name, parent, Quaternion.Identity, new Vector3(x, y, z));
    }

    /// <summary>A person of tubes under way.</summary>
    private sealed class Walk
    {
        private readonly Quaternion[] localRotations;
        private readonly Vector3[] localPositions;
        private readonly Quaternion[] modelRotations;
        private readonly Vector3[] modelPositions;
        private readonly Matrix4x4[] matrices;
        private readonly Vector3[] positions;
        private readonly Vector3[] normals;
        private readonly SkinnedMesh skin;

        public Walk(Skeleton skeleton)
        {
            skin = SkinOf(skeleton);
            Body = new RiggedBody(skeleton, skin: skin);
            Animator = new CreatureAnimator(new MotionProfile(Body.Subject));
            localRotations = new Quaternion[skeleton.Count];
            localPositions = new Vector3[skeleton.Count];
            modelRotations = new Quaternion[skeleton.Count];
            modelPositions = new Vector3[skeleton.Count];
            matrices = new Matrix4x4[skeleton.Count];
            positions = new Vector3[skin.Positions.Length];
            normals = new Vector3[skin.Positions.Length];
        }

        public RiggedBody Body { get; }

        public CreatureAnimator Animator { get; }

        public void Step(float speed)
        {
            Animator.Update(1f / 60f, new MotionInput(speed), ground);
            Body.FillPose(Animator.ModelPose, new Pose(localRotations, localPositions), new Pose(modelRotations, modelPositions));
        }

        /// <summary>From its rest in the parent's space, radians.</summary>
        public float TurnOf(int joint) => 2f * MathF.Acos(Math.Min(1f, MathF.Abs(Quaternion.Dot(localRotations[joint], Body.Skeleton.LocalRotations[joint]))));

        /// <summary>Height of the lowest vertex above the ground.</summary>
        public float Lowest()
        {
            SkinMatrices.Fill(Body.Skeleton, new Pose(modelRotations, modelPositions), matrices);
            CpuSkinning.Skin(matrices, skin.Weights, skin.Positions, skin.Normals, positions, normals);
            float lowest = float.MaxValue;
            foreach (Vector3 place in positions)
            {
                lowest = Math.Min(lowest, Animator.Root.ToWorld(place - new Vector3(0f, Body.Ground, 0f)).Y);
            }

            return lowest;
        }
    }
}
