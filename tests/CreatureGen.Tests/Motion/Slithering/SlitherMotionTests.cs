using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Slithering;
using Xunit;

namespace CreatureGen.Tests.Motion.Slithering;

public sealed class SlitherMotionTests
{
    private static readonly IGround level = FlatGround.Level;

    [Theory]
    [InlineData(0.85, 0.827394)]
    [InlineData(1.0, 0.765198)]
    [InlineData(0.0, 1.0)]
    public void Progress_is_the_bessel_function(double alpha, double j0) => Assert.Equal(j0, SlitherProfile.Progress(alpha), 4);

    [Theory]
    [InlineData(0f)]
    [InlineData(0.8f)]
    public void Every_joint_behind_the_neck_follows_the_track_of_the_first(float turn)
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            var crawl = new Crawl(profile, creature, level);
            float dt = 0.004f * profile.BodyLength / profile.CruiseSpeed;
            crawl.Run(SlitherGait.Undulating, profile.CruiseSpeed, 0, dt, 600);
            int first = profile.Chain.Bones[profile.NeckBones - 1].Turn.Joint;
            var track = new List<Vector3>();
            for (int i = 0; i < 500; i++)
            {
                crawl.Step(SlitherGait.Undulating, profile.CruiseSpeed, turn * profile.CruiseSpeed / profile.BodyLength, dt);
                track.Add(crawl.World(first));
            }

            // It went two body lengths: by now every joint lies on what it left behind.
            for (int b = profile.NeckBones + 1; b < profile.Chain.Count; b++)
            {
                Vector3 joint = crawl.World(profile.Chain.Bones[b].Turn.Joint);
                float away = float.MaxValue;
                for (int k = 1; k < track.Count; k++)
                {
                    away = Math.Min(away, LevelDistance(joint, track[k - 1], track[k]));
                }

                Assert.True(away < 0.012f * profile.BodyLength, FormattableString.Invariant($"{creature.Blueprint.Seed} {profile.Skeleton.Joints[profile.Chain.Bones[b].Turn.Joint].Name}: {away / profile.BodyLength} L beside the track"));
            }
        }
    }

    [Fact]
    public void Nothing_behind_the_neck_slips_sideways()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            var crawl = new Crawl(profile, creature, level);
            float dt = 0.002f * profile.BodyLength / profile.CruiseSpeed;
            crawl.Run(SlitherGait.Undulating, profile.CruiseSpeed, 0, 10 * dt, 300);
            double worst = 0;
            double sum = 0;
            int count = 0;
            for (int i = 0; i < 200; i++)
            {
                Vector3[] before = crawl.Points();
                crawl.Step(SlitherGait.Undulating, profile.CruiseSpeed, 0, dt);
                Vector3[] after = crawl.Points();
                for (int b = profile.NeckBones; b + 1 < before.Length; b++)
                {
                    // Velocity of the joint across the mean direction of the two bones that meet in it.
                    Vector3 along = after[b - 1] - after[b + 1];
                    along = Vec.Normalize(new Vector3(along.X, 0, along.Z));
                    Vector3 moved = after[b] - before[b];
                    double across = Math.Abs((moved.X * along.Z) - (moved.Z * along.X)) / (profile.CruiseSpeed * dt);
                    worst = Math.Max(worst, across);
                    sum += across;
                    count++;
                }
            }

            Assert.True(sum / count < 0.05, FormattableString.Invariant($"{creature.Blueprint.Seed}: mean slip {sum / count}"));
            // Worst at the stiff joints of a cobra's hood.
            Assert.True(worst < 0.3, FormattableString.Invariant($"{creature.Blueprint.Seed}: worst slip {worst}"));
        }
    }

    [Theory]
    [InlineData(0f)]
    [InlineData(0.8f)]
    public void The_head_looks_steadily_along_the_way(float turn)
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless, 20))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            var crawl = new Crawl(profile, creature, level);
            float dt = 0.01f * profile.BodyLength / profile.CruiseSpeed;
            float rate = turn * profile.CruiseSpeed / profile.BodyLength;
            crawl.Run(SlitherGait.Undulating, profile.CruiseSpeed, rate, dt, 300);
            double head = 0;
            double chest = 0;
            for (int i = 0; i < 300; i++)
            {
                crawl.Step(SlitherGait.Undulating, profile.CruiseSpeed, rate, dt);
                head = Math.Max(head, Math.Abs(crawl.Heading(0)));
                chest = Math.Max(chest, Math.Abs(crawl.Heading(profile.NeckBones)));
            }

            Assert.True(chest > 0.5, FormattableString.Invariant($"{creature.Blueprint.Seed}: the chest swings by {chest}"));
            Assert.True(head < 0.12, FormattableString.Invariant($"{creature.Blueprint.Seed}: the head swings by {head}"));
        }
    }

    [Theory]
    [InlineData(SlitherGait.Undulating)]
    [InlineData(SlitherGait.Sidewinding)]
    [InlineData(SlitherGait.Rectilinear)]
    public void It_gets_on_at_the_speed_asked_for_straight_ahead(SlitherGait mode)
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            var crawl = new Crawl(profile, creature, level);
            float dt = 0.01f * profile.BodyLength / profile.CruiseSpeed;
            crawl.Run(mode, profile.CruiseSpeed, 0, dt, 800);
            Vector3 from = crawl.Root.Position;
            Quaternion facing = crawl.Root.Rotation;
            crawl.Run(mode, profile.CruiseSpeed, 0, dt, 600);
            Vector3 moved = crawl.Root.Position - from;
            float way = profile.CruiseSpeed * dt * 600;
            Assert.True(Rotation.Angle(Rotation.Multiply(Rotation.Inverse(facing), crawl.Root.Rotation)) < 1e-3);
            Assert.True(Math.Abs(moved.Z - way) < 0.04f * way, FormattableString.Invariant($"{mode} {creature.Blueprint.Seed}: {moved.Z / way} of the way"));
            Assert.True(Math.Abs(moved.X) < 0.06f * way, FormattableString.Invariant($"{mode} {creature.Blueprint.Seed}: {moved.X / way} aside"));
        }
    }

    [Theory]
    [InlineData(SlitherGait.Undulating)]
    [InlineData(SlitherGait.Sidewinding, Explicit = true)]
    [InlineData(SlitherGait.Rectilinear, Explicit = true)]
    public void Every_joint_stays_within_its_limits(SlitherGait mode)
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            var crawl = new Crawl(profile, creature, new Hills(0.05f * profile.BodyLength, 6 / profile.BodyLength));
            for (int i = 0; i < 600; i++)
            {
                crawl.Step(mode, (float)(profile.CruiseSpeed * (1 + PortableMath.Sin(0.02 * i))), (float)(3 * PortableMath.Sin(0.013 * i)), 0.02f * profile.BodyLength / profile.CruiseSpeed);
                crawl.Body.AssertWithinLimits(FormattableString.Invariant($"{mode} {creature.Blueprint.Seed} step {i}"));
            }
        }
    }

    [Fact]
    public void What_rests_in_sidewinding_does_not_slide_and_the_rest_is_lifted()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            var crawl = new Crawl(profile, creature, level);
            float dt = 0.004f * profile.BodyLength / profile.CruiseSpeed;
            crawl.Run(SlitherGait.Sidewinding, profile.CruiseSpeed, 0, dt, 2500);
            double slide = 0;
            double carried = 0;
            double lift = 0;
            int count = 0;
            for (int i = 0; i < 200; i++)
            {
                Vector3[] before = crawl.Points();
                crawl.Step(SlitherGait.Sidewinding, profile.CruiseSpeed, 0, dt);
                Vector3[] after = crawl.Points();

                // The middle of what rests, and the highest.
                double Over(int b) => after[b].Y - profile.Chain.Bones[b].Rear.Y;
                int low = 3;
                int high = 3;
                for (int b = 3; b + 2 < after.Length; b++)
                {
                    low = Over(b - 1) + (2 * Over(b)) + Over(b + 1) < Over(low - 1) + (2 * Over(low)) + Over(low + 1) - 1e-5 ? b : low;
                    high = Over(b) > Over(high) ? b : high;
                }

                slide += Vec.Distance(after[low], before[low]);
                carried += Vec.Distance(after[high], before[high]);
                lift += (Over(high) - Over(low)) / profile.Wavelength;
                count++;
            }

            Assert.True(slide < 0.2 * carried, FormattableString.Invariant($"{creature.Blueprint.Seed}: what rests slides {slide / carried} times as fast as what is lifted"));
            Assert.True(lift / count > 0.02, FormattableString.Invariant($"{creature.Blueprint.Seed}: lifted by {lift / count} wavelengths"));
        }
    }

    [Theory]
    [InlineData(0f, 0.55f)]
    [InlineData(0.55f, 0f)]
    [InlineData(-0.3f, -0.4f)]
    public void The_belly_lies_on_a_slope(float slopeX, float slopeZ)
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            Vector3 up = Vec.Normalize(new Vector3(-slopeX, 1, -slopeZ));
            var slope = new FlatGround(Vector3.Zero, up);
            var crawl = new Crawl(profile, creature, slope);
            float dt = 0.02f * profile.BodyLength / profile.CruiseSpeed;
            crawl.Run(SlitherGait.Undulating, profile.CruiseSpeed, 0.1f, dt, 300);
            crawl.Body.ToModel();
            for (int b = 1; b < profile.Chain.Count; b++)
            {
                int joint = profile.Chain.Bones[b].Turn.Joint;
                Vector3 world = crawl.World(joint);
                double over = Vec.Dot(world, up);
                double rest = creature.Skeleton.ModelPositions[joint].Y;
                Assert.True(Math.Abs(over - rest) < 0.012 * profile.BodyLength, FormattableString.Invariant($"{creature.Blueprint.Seed} {profile.Skeleton.Joints[joint].Name}: {over} over the ground, {rest} at rest"));
            }
        }
    }

    [Theory]
    [InlineData(0.2f)]
    [InlineData(5f)]
    public void It_crawls_alike_on_a_plane_a_height_field_and_a_mesh_at_any_scale(float scale)
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
        float slope = 0.3f;
        Vector3 At(float x, float z) => new(x, slope * x, z);
        float dt = 0.02f * profile.BodyLength / profile.CruiseSpeed;
        var field = new HeightFieldGround([-60f, 0f, 60f, -60f, 0f, 60f, -60f, 0f, 60f], 3, 200f, new Vector3(-200f, 0f, -200f));
        var mesh = new MeshGround([At(-200f, -200f), At(200f, -200f), At(200f, 200f), At(-200f, 200f)], [0, 2, 1, 0, 3, 2]);
        var plane = new Crawl(profile, creature, new FlatGround(Vector3.Zero, new Vector3(-slope, 1f, 0f))) { Root = new RootPlace(Vector3.Zero, Quaternion.Identity, scale) };
        plane.Run(SlitherGait.Undulating, profile.CruiseSpeed, 0.1f, dt, 200);
        Assert.True(Vec.Length(plane.Root.Position) > 0.5f * scale * profile.BodyLength);
        foreach (IGround ground in new IGround[] { field, mesh })
        {
            var crawl = new Crawl(profile, creature, ground) { Root = new RootPlace(Vector3.Zero, Quaternion.Identity, scale) };
            crawl.Run(SlitherGait.Undulating, profile.CruiseSpeed, 0.1f, dt, 200);
            Assert.True(crawl.Body.Apart(plane.Body.Rotations) < 0.01, FormattableString.Invariant($"{ground.GetType().Name}: {crawl.Body.Apart(plane.Body.Rotations)}"));
            Assert.True(Vec.Distance(crawl.Root.Position, plane.Root.Position) < 2e-3f * scale * profile.BodyLength);
        }
    }

    [Fact]
    public void It_goes_on_level_where_there_is_no_ground()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
        float half = 0.5f * profile.BodyLength;
        var ledge = new MeshGround([new(-half, 0f, -9f), new(half, 0f, -9f), new(half, 0f, half), new(-half, 0f, half)], [0, 2, 1, 0, 3, 2]);
        var crawl = new Crawl(profile, creature, ledge);
        crawl.Run(SlitherGait.Undulating, profile.CruiseSpeed, 0, 0.02f * profile.BodyLength / profile.CruiseSpeed, 200);
        Assert.True(crawl.Root.Position.Z > 2 * half);
        Assert.Equal(0f, crawl.Root.Position.Y, 1e-4f);
        crawl.Body.AssertWithinLimits("beyond the edge");
    }

    [Fact]
    public void A_wave_under_steady_input_closes()
    {
        foreach (Creature creature in StrokeSubject.Of(BodyPlan.Legless))
        {
            SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
            var crawl = new Crawl(profile, creature, level);
            float speed = (float)(profile.CruiseSpeed * SlitherProfile.Progress(profile.Alpha));
            double period = profile.Wavelength / profile.CruiseSpeed;
            crawl.Run(SlitherGait.Undulating, speed, 0, (float)(period / 60), 600);
            Quaternion[] first = (Quaternion[])crawl.Body.Rotations.Clone();
            Vector3 place = crawl.Body.Positions[profile.Chain.Body];
            crawl.Run(SlitherGait.Undulating, speed, 0, (float)(period / 60), 60);
            Assert.True(crawl.Body.Apart(first) < 5e-3, FormattableString.Invariant($"{creature.Blueprint.Seed}: {crawl.Body.Apart(first)}"));
            Assert.True(Vec.Distance(place, crawl.Body.Positions[profile.Chain.Body]) < 2e-3f * profile.BodyLength);
        }
    }

    [Fact]
    public void Frame_rates_agree()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
        Quaternion[]? reference = null;
        Vector3 place = default;
        foreach (int rate in new[] { 30, 60, 144 })
        {
            var crawl = new Crawl(profile, creature, level);
            for (int i = 0; i < 8 * rate; i++)
            {
                int second = i / rate;
                crawl.Step(SlitherGait.Undulating, (1 + (second % 2)) * profile.CruiseSpeed, second % 3 == 0 ? 0.2f : -0.1f, 1f / rate);
            }

            place = reference == null ? crawl.Root.Position : place;
            reference ??= (Quaternion[])crawl.Body.Rotations.Clone();
            Assert.True(crawl.Body.Apart(reference) < 0.02, FormattableString.Invariant($"{rate} Hz: {crawl.Body.Apart(reference)}"));
            Assert.True(Vec.Distance(place, crawl.Root.Position) < 5e-3f * profile.BodyLength);
        }
    }

    [Fact]
    public void A_crawler_that_is_carried_elsewhere_keeps_its_shape()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
        var crawl = new Crawl(profile, creature, level);
        crawl.Run(SlitherGait.Undulating, profile.CruiseSpeed, 0.1f, 0.05f, 200);
        Quaternion[] shape = (Quaternion[])crawl.Body.Rotations.Clone();
        crawl.Root = new RootPlace(crawl.Root.Position + new Vector3(30, 0, -50), Rotation.Multiply(crawl.Root.Rotation, Rotation.FromAxisAngle(Vector3.UnitY, 1)));
        crawl.Step(SlitherGait.Undulating, profile.CruiseSpeed, 0.1f, 0);
        Assert.True(crawl.Body.Apart(shape) < 2e-3, FormattableString.Invariant($"{crawl.Body.Apart(shape)}"));
    }

    [Fact]
    public void Changes_of_speed_course_and_mode_have_no_jump()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
        float Max(int rate)
        {
            var crawl = new Crawl(profile, creature, level);
            float dt = profile.BodyLength / profile.CruiseSpeed / rate;
            float max = 0;
            Quaternion[] before = (Quaternion[])crawl.Body.Rotations.Clone();
            for (int i = 0; i < 12 * rate; i++)
            {
                int part = i / rate;
                crawl.Step((SlitherGait)(part / 3 % 3), (part % 3) * profile.CruiseSpeed, part % 2 == 0 ? 0.2f : -0.2f, dt);
                max = i == 0 ? 0 : Math.Max(max, (float)crawl.Body.Apart(before));
                before = (Quaternion[])crawl.Body.Rotations.Clone();
            }

            return max;
        }

        // A jump would be as large at any rate.
        float coarse = Max(100);
        float fine = Max(400);
        Assert.True(fine < 0.4f * coarse, FormattableString.Invariant($"{coarse} at 100, {fine} at 400"));
    }

    [Fact]
    public void Updates_allocate_nothing_and_repeat_to_the_bit()
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
        var a = new Crawl(profile, creature, level);
        var b = new Crawl(profile, creature, level);
        a.Run(SlitherGait.Sidewinding, 1, 0.1f, 0.02f, 210);
        b.Run(SlitherGait.Sidewinding, 1, 0.1f, 0.02f, 210);
        Assert.Equal(a.Body.Rotations, b.Body.Rotations);
        Assert.Equal(0, MovingPose.Allocated(() => a.Run(SlitherGait.Sidewinding, 1, 0.1f, 0.02f, 40), 5));
    }

    [Theory]
    [InlineData(float.NaN, 0f, 0.1f)]
    [InlineData(1f, float.NaN, 0.1f)]
    [InlineData(1f, 0f, -1f)]
    public void Numbers_that_are_none_are_refused(float speed, float yaw, float dt)
    {
        Creature creature = StrokeSubject.Of(BodyPlan.Legless)[0];
        var crawl = new Crawl(SlitherProfile.Of(new MotionSubject(creature)), creature, level);
        Assert.ThrowsAny<ArgumentException>(() => crawl.Step(SlitherGait.Undulating, speed, yaw, dt));
    }

    [Theory]
    [InlineData(0.05)]
    [InlineData(20)]
    public void Any_size_crawls(double scale)
    {
        Creature creature = StrokeSubject.Find(BodyPlan.Legless, 1, scale, scale)[0];
        SlitherProfile profile = SlitherProfile.Of(new MotionSubject(creature));
        var crawl = new Crawl(profile, creature, level);
        for (int i = 0; i < 100; i++)
        {
            crawl.Step(SlitherGait.Undulating, profile.CruiseSpeed, 0.1f, 0.1f);
            crawl.Body.AssertWithinLimits(FormattableString.Invariant($"at {scale}"));
        }
    }

    private static float LevelDistance(Vector3 p, Vector3 a, Vector3 b)
    {
        p.Y = a.Y = b.Y = 0;
        Vector3 d = b - a;
        float t = Scalar.Clamp(Vec.Dot(p - a, d) / Math.Max(Vec.LengthSquared(d), 1e-12f), 0f, 1f);
        return Vec.Distance(p, a + (d * t));
    }

    private sealed class Hills : IGround
    {
        private readonly float height;
        private readonly float frequency;

        public Hills(float height, float frequency)
        {
            this.height = height;
            this.frequency = frequency;
        }

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            PortableMath.SinCos(origin.X * frequency, out double sx, out double cx);
            PortableMath.SinCos(origin.Z * frequency, out double sz, out double cz);
            Vector3 normal = Vec.Normalize(new Vector3((float)(-height * frequency * cx * sz), 1, (float)(-height * frequency * sx * cz)));
            hit = new GroundHit(new Vector3(origin.X, (float)(height * sx * sz), origin.Z), normal);
            return direction == -Vector3.UnitY && hit.Point.Y <= origin.Y && hit.Point.Y >= origin.Y - distance;
        }
    }

    private sealed class Crawl
    {
        private readonly SlitherProfile profile;
        private readonly SlitherState state;
        private readonly IGround ground;

        public Crawl(SlitherProfile profile, Creature creature, IGround ground)
        {
            this.profile = profile;
            this.ground = ground;
            state = new SlitherState(profile);
            Body = new StrokeSubject(creature);
            Root = RootPlace.Identity;
        }

        public StrokeSubject Body { get; }

        public RootPlace Root { get; set; }

        public void Step(SlitherGait mode, float speed, float yaw, float dt) =>
            Root = SlitherMotion.Update(profile, new SlitherInput(mode, speed, yaw, Root), ground, state, dt, Body.Local);

        public void Run(SlitherGait mode, float speed, float yaw, float dt, int steps)
        {
            for (int i = 0; i < steps; i++)
            {
                Step(mode, speed, yaw, dt);
            }
        }

        public Vector3 World(int joint)
        {
            Body.ToModel();
            return Root.ToWorld(Body.ModelPositions[joint]);
        }

        /// <summary>How far a bone heads to the left of the way at the head, radians.</summary>
        public double Heading(int bone)
        {
            Body.ToModel();
            int joint = profile.Chain.Bones[bone].Turn.Joint;
            Vector3 ahead = Rotation.Rotate(Rotation.Multiply(Body.ModelRotations[joint], Rotation.Inverse(Body.Skeleton.ModelRotations[joint])), Vector3.UnitZ);
            double angle = PortableMath.Atan2(ahead.X, ahead.Z) - (state.CourseAngle - state.Yaw);
            return PortableMath.Atan2(PortableMath.Sin(angle), PortableMath.Cos(angle));
        }

        /// <summary>Where the bones meet, from the head's joint to the last bone's, world space.</summary>
        public Vector3[] Points()
        {
            Body.ToModel();
            var points = new Vector3[profile.Chain.Count];
            for (int b = 0; b < points.Length; b++)
            {
                var bone = profile.Chain.Bones[Math.Max(b, 1)];
                int joint = bone.Turn.Joint;
                Quaternion turn = Rotation.Multiply(Body.ModelRotations[joint], Rotation.Inverse(Body.Skeleton.ModelRotations[joint]));
                Vector3 front = Body.ModelPositions[joint] + Rotation.Rotate(turn, (b == 0 ? bone.Front : bone.Rear) - Body.Skeleton.ModelPositions[joint]);
                points[b] = Root.ToWorld(front);
            }

            return points;
        }
    }
}
