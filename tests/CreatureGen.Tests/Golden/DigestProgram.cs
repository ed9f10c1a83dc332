using System.IO;
using System.Reflection;
using CreatureGen.Digest;
using CreatureGen.Tests.Conventions;

namespace CreatureGen.Tests.Golden;

/// <summary>The program that prints hashes, in a process of its own.</summary>
internal static class DigestProgram
{
    /// <summary>Built as these tests are, with the library as it is shipped. The one beside the tests has it compiled ahead.</summary>
    public static string Plain { get; } = Built(typeof(DigestProgram).Assembly.GetCustomAttribute<AssemblyConfigurationAttribute>()!.Configuration);

    /// <summary>With the library compiled without optimisation, where that has been built.</summary>
    public static string Debug { get; } = Built("Debug");

    /// <summary>The one beside the tests.</summary>
    public static string Beside { get; } = typeof(GoldenEntry).Assembly.Location;

    private static string Built(string configuration) => Path.Combine(RepositoryFiles.Root, "tests", Path.GetFileNameWithoutExtension(typeof(GoldenEntry).Assembly.Location), "bin", configuration, "net10.0", Path.GetFileName(typeof(GoldenEntry).Assembly.Location));
}
