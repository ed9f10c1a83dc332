using System;
using System.Linq;

namespace CreatureGen.Tests.Documents;

/// <summary>What the pieces of C# in the documents take for granted: a program that has a creature and the other things they name.</summary>
internal static class DocumentScene
{
    /// <summary>Namespaces of a program that uses all of the library.</summary>
    public static string Usings { get; } = string.Concat(
        new[] { "System", "System.Collections.Generic", "System.IO", "System.Linq", "System.Numerics" }
            .Concat(typeof(CreatureGenerator).Assembly.GetExportedTypes().Select(type => type.Namespace!).Distinct().Order(StringComparer.Ordinal))
            .Select(name => $"using {name};\n"));

    /// <summary>Members that a piece may name.</summary>
    public const string Members = """
        static Creature creature = null!;
        static CreatureBlueprint blueprint = null!, edited = null!, mother = null!, father = null!, adult = null!;
        static CreatureOptions options = null!;
        static CreatureAnimator animator = null!;
        static MotionProfile profile = null!;
        static Skeleton skeleton = null!;
        static Skeleton human = null!;
        static LimbChain limb = null!;
        static Stream stream = null!, destination = null!;
        static IGround ground = null!;
        static Seed seed;
        static float dt, timeSinceSwitch;
        static double time;
        static bool seesPlayer;
        static Vector3[] homes = null!, homesNow = null!;
        static Vector3 pole;
        static int i;
        static int hip, knee, ankle, ball, joint;
        static int[] tailJoints = null!;
        static float[] totals = null!, armMask = null!;
        static Vector3 ledge, start, position, target, ballTarget, grabPoint, playerModel, playerWorld, hitPoint, originShift;
        static Quaternion heading, rotation;
        static float scale;
        static RootPlace place, newPlace, placeBefore, gamePlace;
        static BodyVelocity velocity;
        static PushedRoot pushed;
        static SeekState seek;
        static Matrix4x4[] matrices = null!;
        static SpringCollider[] colliders = null!;
        static InertialOffset[] offsets = null!;
        static Clip clip = null!;
        static void Play(int sound, float loudness, float secondsAgo) { }
        static Pose local => default;
        static Pose model => default;
        static Pose pose => default;
        static Pose rest => default;
        static Pose walk => default;
        static Pose wave => default;
        static Pose shown => default;
        static Pose shownBefore => default;
        static Pose next => default;
        static Pose nextBefore => default;
        static Pose modelBefore => default;
        static Pose lying => default;
        static Pose lyingModel => default;
        static Pose boneRotationsAndPositions => default;
        """;
}
