using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using CreatureGen.Preview.Rendering;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed class SwitchTests
{
    private static readonly Assembly[] Libraries = [typeof(CreatureGenerator).Assembly, typeof(Renderer).Assembly];

    [Fact]
    public void Public_methods_have_no_switches()
    {
        string[] wrong = Offered()
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
        string[] wrong = Offered()
            .SelectMany(t => t.GetConstructors())
            .Where(c => c.GetParameters().Any(p => p.ParameterType == typeof(bool) && c.DeclaringType!.GetProperty(p.Name!)?.PropertyType != typeof(bool)))
            .Select(c => c.DeclaringType!.FullName!)
            .ToArray();
        Assert.True(wrong.Length == 0, "constructors with a bool parameter that is no property: " + string.Join(", ", wrong));
    }

    private static IEnumerable<Type> Offered() => Libraries.SelectMany(a => a.GetExportedTypes());
}
