using System;
using System.IO;
using System.Linq;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;
#if EARLIER
using CreatureGen.Animation;
using CreatureGen.Animation.Grounds;
using CreatureGen.Animation.Poses;
using CreatureGen.Animation.RootMotion;
#else
using CreatureGen.Motion;
using CreatureGen.Motion.Grounds;
using CreatureGen.Motion.Toolkit;
#endif

namespace CreatureGen.Benchmarks.Probe;

/// <summary>The work that is timed, by name.</summary>
internal static class Rows
{
    /// <summary>Creatures of a crowd, and how many of them are timed together.</summary>
    private const int CrowdSize = 512;
    private const int CrowdBlock = 8;

    /// <summary>Repetitions of what takes less than a microsecond.</summary>
    private const int Repeats = 200;

    private const int Budget = 6000;
    private const int FineBudget = 16000;
    private const int AtlasSize = 1024;

    /// <summary>A row of work on the given subjects.</summary>
    /// <exception cref="ArgumentException">There is no such row.</exception>
    public static Row Of(string name, Subjects subjects) => name switch
    {
        "creature" => new Row(subjects.Blueprints.Select<CreatureBlueprint, Action>(b => () => CreatureAssembler.Assemble(b)).ToArray()),
        "blueprint" => new Row(Enumerable.Range(0, 60).Select<int, Action>(seed => () => BlueprintSampler.Sample((ulong)seed, Animals)).ToArray()),
        "levels" => new Row(subjects.Creatures.Take(24).Select<Creature, Action>(c => () => Levels(c.Mesh)).ToArray()),
        "budget" => new Row(subjects.Blueprints.Take(24).Select(b => b with { TriangleBudget = Budget }).Select<CreatureBlueprint, Action>(b => () => CreatureAssembler.Assemble(b)).ToArray()),
        "fine" => new Row(subjects.Blueprints.Take(24).Select(b => b with { TriangleBudget = FineBudget }).Select<CreatureBlueprint, Action>(b => () => CreatureAssembler.Assemble(b)).ToArray()),
        "glb" => Glb(subjects, GltfOptions.Default, 24),
        "atlas" => Glb(subjects, GltfOptions.Default with { TextureSize = AtlasSize }, 6),
        "profile" => new Row(subjects.Creatures.Take(60).Select<Creature, Action>(c => () => new MotionProfile(c)).ToArray()),
        "walk" => March(subjects, p => p.Legs != null && p.Legs.Rows == 2 && p.Flight == null, p => new MotionInput(p.Gaits!.Speeds[0].Comfortable)),
        "crowd" => Crowds(subjects, p => p.Legs != null && p.Legs.Rows == 2 && p.Flight == null, p => new MotionInput(p.Gaits!.Speeds[0].Comfortable)),
        "far" => March(subjects, p => p.Legs != null && p.Legs.Rows == 2 && p.Flight == null, p => new MotionInput(p.Gaits!.Speeds[0].Comfortable), Far),
        "stand" => March(subjects, p => p.Legs != null && p.Legs.Rows == 2 && p.Flight == null, _ => default),
        "crawl" => March(subjects, p => p.Slither != null, _ => new MotionInput(0.5f)),
        "fly" => March(subjects, p => p.Flight != null, _ => new MotionInput(5f, Medium: MotionMedium.Air)),
        "swim" => March(subjects, p => p.Swim != null, _ => new MotionInput(1f)),
        "blend" => Poses(subjects, Blend),
        "mixer" => Poses(subjects, Mix),
        "chain" => Poses(subjects, Chain),
        "twobone" => new Row(new Action[] { () => Limbs.TwoBones(Repeats) }, Repeats),
        "pantograph" => new Row(new Action[] { () => Limbs.Pantograph(Repeats) }, Repeats),
        "skinning" => Skinning(subjects),
        "meshground" => MeshGrounds(),
        _ => throw new ArgumentException($"no row '{name}'", nameof(name)),
    };

#if EARLIER
    private static CreatureOptions Animals => CreatureOptions.Default;

    private static void Levels(CreatureMesh mesh) => CreatureLevels.Of(mesh);

    /// <summary>There was nothing of the kind: the share is that of an update in full.</summary>
    private static void Far(CreatureAnimator animator)
    {
    }

    /// <summary>There was nothing of the kind: the share is that of updates of single animators.</summary>
    private static Row Crowds(Subjects subjects, Predicate<MotionProfile> chosen, Func<MotionProfile, MotionInput> asked) => March(subjects, chosen, asked);

    private static CreatureMesh MeshOf(MotionProfile profile) => profile.Creature.Mesh;
#else
    private static CreatureOptions Animals => CreatureOptions.Default with { Strangeness = 0 };

    private static void Levels(CreatureMesh mesh) => CreatureLods.Of(mesh);

    private static void Far(CreatureAnimator animator)
    {
        MotionSettings settings = animator.Settings;
        settings.Detail = MotionDetail.Far;
        animator.Settings = settings;
    }

    /// <summary>As many as in a march, in crowds of one profile each.</summary>
    private static Row Crowds(Subjects subjects, Predicate<MotionProfile> chosen, Func<MotionProfile, MotionInput> asked)
    {
        MotionProfile[] profiles = subjects.Profiles.Where(p => chosen(p)).ToArray();
        int size = Math.Max(CrowdSize / profiles.Length, 1);
        return new Row(
            profiles.Select<MotionProfile, Action>(profile =>
            {
                var crowd = new Crowd(profile, size);
                var inputs = new MotionInput[size];
                Array.Fill(inputs, asked(profile));
                for (int i = 0; i < size; i++)
                {
                    crowd[i].Teleport(new RootPlace(new Vector3(i * 10f, 0f, 0f), Quaternion.Identity), FlatGround.Level);
                    for (int k = 0; k < 7 * i % 40; k++)
                    {
                        crowd[i].Update(1f / 60f, inputs[i], FlatGround.Level);
                    }
                }

                return () => crowd.Update(1f / 60f, inputs, FlatGround.Level);
            }).ToArray(),
            size);
    }

    private static CreatureMesh MeshOf(MotionProfile profile) => profile.Subject.Mesh;
#endif

    private static Row Glb(Subjects subjects, GltfOptions options, int count)
    {
        var file = new MemoryStream(8 << 20);
        return new Row(subjects.Creatures.Take(count).Select<Creature, Action>(c => () =>
        {
            file.Position = 0;
            GlbWriter.Write(c, options, file);
        }).ToArray());
    }

    private static Row March(Subjects subjects, Predicate<MotionProfile> chosen, Func<MotionProfile, MotionInput> asked, Action<CreatureAnimator>? prepared = null)
    {
        MotionProfile[] profiles = subjects.Profiles.Where(p => chosen(p)).ToArray();
        var animators = new CreatureAnimator[CrowdSize];
        var inputs = new MotionInput[CrowdSize];
        for (int i = 0; i < CrowdSize; i++)
        {
            MotionProfile profile = profiles[i % profiles.Length];
            inputs[i] = asked(profile);
            animators[i] = new CreatureAnimator(profile);
            animators[i].Teleport(new RootPlace(new Vector3(i * 10f, inputs[i].Medium == MotionMedium.Air ? 30f : 0f, 0f), Quaternion.Identity), FlatGround.Level);
            prepared?.Invoke(animators[i]);
            for (int k = 0; k < 7 * i % 40; k++)
            {
                animators[i].Update(1f / 60f, inputs[i], FlatGround.Level);
            }
        }

        return new Row(
            Enumerable.Range(0, CrowdSize / CrowdBlock).Select<int, Action>(block => () =>
            {
                for (int i = block * CrowdBlock; i < (block + 1) * CrowdBlock; i++)
                {
                    animators[i].Update(1f / 60f, inputs[i], FlatGround.Level);
                }
            }).ToArray(),
            CrowdBlock);
    }

    private static Row Poses(Subjects subjects, Action<PosePair> work) => new(
        subjects.Profiles.Take(24).Select<MotionProfile, Action>(p =>
        {
            var pair = new PosePair(p);
            return () =>
            {
                for (int i = 0; i < Repeats; i++)
                {
                    work(pair);
                }
            };
        }).ToArray(),
        Repeats);

    private static void Blend(PosePair pair) => PoseBlend.Mix(pair.First, pair.Second, 0.3f, pair.Result);

    private static void Mix(PosePair pair)
    {
        var mixer = new PoseMixer(pair.Result, pair.Totals);
        mixer.Add(pair.First, 0.3f);
        mixer.Add(pair.Second, 0.7f);
        mixer.Finish(pair.First);
    }

    private static void Chain(PosePair pair) => ForwardKinematics.LocalToModel(pair.Skeleton, pair.First, pair.Result);

    private static Row Skinning(Subjects subjects) => new(subjects.Profiles.Take(24).Select<MotionProfile, Action>(p =>
    {
        var pair = new PosePair(p);
        ForwardKinematics.LocalToModel(pair.Skeleton, pair.First, pair.Result);
        var matrices = new Matrix4x4[pair.Skeleton.Count];
        SkinMatrices.Fill(pair.Skeleton, pair.Result, matrices);
        CreatureMesh mesh = MeshOf(p);
        var positions = new Vector3[mesh.Positions.Length];
        var normals = new Vector3[mesh.Positions.Length];
        return () => CpuSkinning.Skin(matrices, mesh.Weights, mesh.Positions, mesh.Normals, positions, normals);
    }).ToArray());

    private static Row MeshGrounds()
    {
        const int Side = 224;
        var positions = new Vector3[(Side + 1) * (Side + 1)];
        var triangles = new int[Side * Side * 6];
        for (int z = 0, next = 0; z <= Side; z++)
        {
            for (int x = 0; x <= Side; x++)
            {
                positions[(z * (Side + 1)) + x] = new Vector3(x, (x * 7 + z * 13) % 11 * 0.1f, z);
                if (x < Side && z < Side)
                {
                    int corner = (z * (Side + 1)) + x;
                    foreach (int index in new[] { corner, corner + Side + 1, corner + 1, corner + 1, corner + Side + 1, corner + Side + 2 })
                    {
                        triangles[next++] = index;
                    }
                }
            }
        }

        return new Row(new Action[] { () => new MeshGround(positions, triangles) });
    }
}
