using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Gltf.Models;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using CreatureGen.Tests.Gltf.Models;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Gltf;

/// <summary>Poses of a reader that shares no code with the library, at random times, beside those of the library's own sampler.</summary>
public sealed class GlbClipPoseTests
{
    private const float Apart = 1e-4f;
    private const int Times = 5;

    [Theory]
    [InlineData("feline", RequestedKind.Walking, KeyInterpolation.Linear)]
    [InlineData("feline", RequestedKind.Walking, KeyInterpolation.Cubic, Explicit = true)]
    [InlineData("raptor", RequestedKind.Flying, KeyInterpolation.Linear, Explicit = true)]
    [InlineData("fish", RequestedKind.Swimming, KeyInterpolation.Step, Explicit = true)]
    [InlineData("cobra", RequestedKind.Walking, KeyInterpolation.Cubic, Explicit = true)]
    public void Joints_are_where_the_library_has_them_at_any_time(string body, RequestedKind kind, KeyInterpolation interpolation)
    {
        Creature creature = SpeciesSubject.Of(body, kind);
        RandomStream random = new Seed(15).Child(body).Stream();
        var precision = new ClipPrecision(1e-4f, 0.03f, interpolation);
        foreach (ClipRecipe recipe in ClipBaker.RecipesOf(new MotionProfile(creature)).Where((_, i) => i % 4 == 1))
        {
            Clip clip = recipe.Bake();
            byte[] file = GlbFile.Write(creature, new GltfOptions { Clips = [clip], ClipPrecision = precision });
            var naive = new NaiveGltf(file);
            IClip read = ModelReader.Read(new System.IO.MemoryStream(file)).GetModel().Clips[0];
            for (int i = 0; i < Times; i++)
            {
                float time = (float)random.Uniform(0, clip.Duration);
                Matrix4x4[] world = naive.World(time);
                var pose = new Pose(new Quaternion[clip.Joints], new Vector3[clip.Joints]);
                read.Sample(time, pose);
                ForwardKinematics.LocalToModel(creature.Skeleton, pose, pose);
                for (int joint = 0; joint < clip.Joints; joint++)
                {
                    Assert.True(Vector3.Distance(world[1 + joint].Translation, pose.Positions[joint]) < Apart, $"{clip.Name} at {time}: {creature.Skeleton.Joints[joint].Name}");
                }
            }
        }
    }
}
