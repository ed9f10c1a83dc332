using System;
using System.Linq;
using System.Reflection;
using System.Runtime.Versioning;
using Xunit;

namespace CreatureGen.Tests.Builds;

/// <summary>The same tests run over both builds of the library, each in a project of its own: these say that they do.</summary>
public sealed class LibraryBuildTests
{
    private static readonly Assembly Library = typeof(CreatureGenerator).Assembly;

    [Fact]
    public void The_tests_run_over_the_build_that_their_project_names()
    {
        AssemblyMetadataAttribute named = Assert.Single(typeof(LibraryBuildTests).Assembly.GetCustomAttributes<AssemblyMetadataAttribute>(), a => a.Key == "LibraryFramework");
        Assert.Equal(named.Value, Library.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName);
    }

    [Fact]
    public void The_library_refers_to_nothing_but_its_framework()
    {
        bool standard = Library.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName.StartsWith(".NETStandard", StringComparison.Ordinal);
        string[] foreign = Library.GetReferencedAssemblies().Select(a => a.Name!).Where(n => standard ? n != "netstandard" : !n.StartsWith("System.", StringComparison.Ordinal)).ToArray();
        Assert.Empty(foreign);
    }
}
