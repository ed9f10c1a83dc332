using System;
using System.Linq;
using System.Reflection;

namespace CreatureGen.Reference;

/// <summary>The names that XML documentation gives to types and members.</summary>
/// <remarks>After the annex "Documentation comments" of the C# specification (ECMA-334).</remarks>
internal static class DocumentationId
{
    public static string Of(MemberInfo member) => member switch
    {
        Type type => "T:" + NameOf(type),
        FieldInfo field => "F:" + MemberName(field),
        EventInfo raised => "E:" + MemberName(raised),
        PropertyInfo property => "P:" + MemberName(property) + Parameters(property.GetIndexParameters()),
        ConstructorInfo constructor => "M:" + NameOf(constructor.DeclaringType!) + ".#ctor" + Parameters(constructor.GetParameters()),
        MethodInfo method => "M:" + MemberName(method) + (method.IsGenericMethod ? "``" + method.GetGenericArguments().Length : "") + Parameters(method.GetParameters())
            + (method.Name is "op_Implicit" or "op_Explicit" ? "~" + Reference(method.ReturnType) : ""),
        _ => throw new ArgumentException("no type and no member of one: " + member, nameof(member)),
    };

    private static string MemberName(MemberInfo member) => NameOf(member.DeclaringType!) + "." + member.Name.Replace('.', '#');

    private static string NameOf(Type type) => (type.IsGenericType ? type.GetGenericTypeDefinition() : type).FullName!.Replace('+', '.');

    private static string Parameters(ParameterInfo[] parameters) => parameters.Length == 0 ? "" : "(" + string.Join(',', parameters.Select(parameter => Reference(parameter.ParameterType))) + ")";

    private static string Reference(Type type)
    {
        if (type.IsByRef)
        {
            return Reference(type.GetElementType()!) + "@";
        }

        if (type.IsArray)
        {
            return Reference(type.GetElementType()!) + (type.GetArrayRank() == 1 ? "[]" : "[" + string.Join(',', Enumerable.Repeat("0:", type.GetArrayRank())) + "]");
        }

        if (type.IsGenericParameter)
        {
            return (type.DeclaringMethod is null ? "`" : "``") + type.GenericParameterPosition;
        }

        if (!type.IsGenericType)
        {
            return NameOf(type);
        }

        string name = NameOf(type);
        return name[..name.IndexOf('`', StringComparison.Ordinal)] + "{" + string.Join(',', type.GetGenericArguments().Select(Reference)) + "}";
    }
}
