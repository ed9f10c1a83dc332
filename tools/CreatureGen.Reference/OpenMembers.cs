using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace CreatureGen.Reference;

/// <summary>What an assembly offers to those who use it.</summary>
internal static class OpenMembers
{
    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    /// <summary>Its public types, by name.</summary>
    public static IEnumerable<Type> TypesOf(Assembly assembly) => assembly.GetExportedTypes().OrderBy(type => type.FullName, StringComparer.Ordinal);

    /// <summary>The public and protected members that a type declares, without those that stand for properties and events.</summary>
    public static IEnumerable<MemberInfo> Of(Type type) => type.GetMembers(Declared).Where(IsOpen);

    private static bool IsOpen(MemberInfo member) => member switch
    {
        FieldInfo field => !field.IsSpecialName && (field.IsPublic || field.IsFamily || field.IsFamilyOrAssembly),
        PropertyInfo property => property.GetAccessors(nonPublic: true).Any(IsSeen),
        EventInfo raised => IsSeen(raised.AddMethod!),
        ConstructorInfo constructor => IsSeen(constructor),
        MethodInfo method => IsSeen(method) && (!method.IsSpecialName || method.Name.StartsWith("op_", StringComparison.Ordinal)),
        _ => false,
    };

    private static bool IsSeen(MethodBase method) => method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly;
}
