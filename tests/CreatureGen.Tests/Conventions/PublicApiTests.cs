using System;
using System.IO;
using System.Linq;
using System.Reflection;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed class PublicApiTests
{
    private const string Baseline = "tests/CreatureGen.Tests/Conventions/PublicApi.txt";

    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    /// <summary>Both builds of the library are held to the same text.</summary>
    [Fact]
    public void The_public_API_is_the_one_that_was_agreed()
    {
        string actual = PublicApiText.Of(typeof(CreatureGenerator).Assembly);
        string renewed = Path.Combine(AppContext.BaseDirectory, "PublicApi.txt");
        File.WriteAllText(renewed, actual);
        string[] agreed = RepositoryFiles.Text(Baseline).ReplaceLineEndings("\n").Split('\n');
        string[] offered = actual.Split('\n');
        string gone = string.Concat(agreed.Except(offered).Take(20).Select(l => "\n- " + l));
        string added = string.Concat(offered.Except(agreed).Take(20).Select(l => "\n+ " + l));
        Assert.True(agreed.SequenceEqual(offered), $"the public API differs from {Baseline}:{gone}{added}\nIf that is meant, copy {Path.GetRelativePath(RepositoryFiles.Root, renewed)} over it.");
    }

    /// <summary>Unity compiles with C# 9 and without the packages of later frameworks.</summary>
    [Fact]
    public void The_public_API_can_be_used_from_C_sharp_9()
    {
        Type[] types = typeof(CreatureGenerator).Assembly.GetExportedTypes();
        MethodBase[] methods = types.SelectMany(t => t.GetMethods(Declared).Concat<MethodBase>(t.GetConstructors(Declared))).Where(m => m.IsPublic || m.IsFamily).ToArray();
        Assert.DoesNotContain(types.SelectMany(t => t.GetMembers(Declared)).Concat(types), m => m.CustomAttributes.Any(a => a.AttributeType.Name == "RequiredMemberAttribute"));
        Assert.DoesNotContain(methods, m => m is { IsStatic: true, IsAbstract: true });
        Assert.DoesNotContain(methods.SelectMany(m => m.GetParameters()), p => p.CustomAttributes.Any(a => a.AttributeType.Name is "ParamCollectionAttribute" or "RequiresLocationAttribute"));
        Assert.DoesNotContain(methods, m => m.CustomAttributes.Any(a => a.AttributeType.Name is "OverloadResolutionPriorityAttribute"));
        string text = PublicApiText.Of(typeof(CreatureGenerator).Assembly);
        Assert.DoesNotContain("Immutable", text, StringComparison.Ordinal);
        Assert.DoesNotContain("Utf8Json", text, StringComparison.Ordinal);
    }
}
