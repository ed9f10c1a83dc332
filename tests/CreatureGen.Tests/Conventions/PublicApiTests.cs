using System;
using System.IO;
using System.Linq;
using System.Reflection;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed class PublicApiTests
{
    private const string Baseline = "tests/CreatureGen.Tests/Conventions/PublicApi.txt";

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

    [Fact]
    public void Public_methods_have_no_switches()
    {
        string[] wrong = typeof(CreatureGenerator).Assembly.GetExportedTypes()
            .SelectMany(t => t.GetMethods(BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly))
            .Where(m => !m.IsSpecialName && m.GetParameters().Any(p => p.ParameterType == typeof(bool)))
            .Select(m => $"{m.DeclaringType!.FullName}.{m.Name}")
            .ToArray();
        Assert.True(wrong.Length == 0, "methods with a bool parameter; expected an enumeration or two methods: " + string.Join(", ", wrong));
    }

    /// <summary>A record's constructor takes what the record holds; any other constructor that takes a bool has a switch.</summary>
    [Fact]
    public void Public_constructors_take_truth_values_only_to_keep_them()
    {
        string[] wrong = typeof(CreatureGenerator).Assembly.GetExportedTypes()
            .SelectMany(t => t.GetConstructors())
            .Where(c => c.GetParameters().Any(p => p.ParameterType == typeof(bool) && c.DeclaringType!.GetProperty(p.Name!)?.PropertyType != typeof(bool)))
            .Select(c => c.DeclaringType!.FullName!)
            .ToArray();
        Assert.True(wrong.Length == 0, "constructors with a bool parameter that is no property: " + string.Join(", ", wrong));
    }
}
