using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text;

namespace CreatureGen.Tests.Conventions;

/// <summary>What a library offers to those who use it, as text: one line for each type and each member, in ordinal order.</summary>
internal static class PublicApiText
{
    private const BindingFlags Declared = BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    private static readonly NullabilityInfoContext Nullability = new();

    /// <summary>The text of an assembly; lines end in a line feed.</summary>
    public static string Of(Assembly assembly)
    {
        var text = new StringBuilder();
        foreach (Type type in assembly.GetExportedTypes().OrderBy(t => t.FullName, StringComparer.Ordinal))
        {
            text.Append(Header(type)).Append('\n');
            foreach (string line in Lines(type).Order(StringComparer.Ordinal))
            {
                text.Append("    ").Append(line).Append('\n');
            }
        }

        return text.ToString();
    }

    private static string Header(Type type)
    {
        string kind = type switch
        {
            { IsEnum: true } => "enum",
            { IsInterface: true } => "interface",
            { IsValueType: true } => IsReadOnly(type) ? "readonly struct" : "struct",
            { IsAbstract: true, IsSealed: true } => "static class",
            _ when typeof(Delegate).IsAssignableFrom(type) => "delegate",
            _ => (type.IsAbstract ? "abstract " : type.IsSealed ? "sealed " : "") + (type.GetMethod("<Clone>$") == null ? "class" : "record"),
        };
        IEnumerable<Type> parents = type.IsEnum ? [Enum.GetUnderlyingType(type)] : type.GetInterfaces().Where(i => i.IsVisible && !Inherited(type, i));
        parents = type.BaseType is { } parent && parent != typeof(object) && parent != typeof(ValueType) && parent != typeof(Enum) ? parents.Prepend(parent) : parents;
        string[] names = parents.Select(NameOf).Order(StringComparer.Ordinal).ToArray();
        return $"{kind} {type.Namespace}.{NameOf(type)}{(names.Length == 0 ? "" : " : " + string.Join(", ", names))}{Constraints(type.GetGenericArguments())}";
    }

    private static IEnumerable<string> Lines(Type type)
    {
        foreach (FieldInfo field in type.GetFields(Declared).Where(f => (f.IsPublic || f.IsFamily) && !f.IsSpecialName))
        {
            string value = field.IsLiteral ? " = " + Literal(field.GetRawConstantValue()) : "";
            yield return type.IsEnum ? field.Name + value : $"field {Modifiers(field)}{NameOf(field.FieldType, Nullability.Create(field))} {field.Name}{value}";
        }

        foreach (PropertyInfo property in type.GetProperties(Declared).Where(p => IsOffered(p.GetMethod) || IsOffered(p.SetMethod)))
        {
            MethodInfo accessor = (property.GetMethod ?? property.SetMethod)!;
            string set = !IsOffered(property.SetMethod) ? "" : IsInit(property.SetMethod!) ? " init;" : " set;";
            string index = property.GetIndexParameters().Length == 0 ? "" : $"[{Parameters(property.GetIndexParameters())}]";
            yield return $"property {Modifiers(accessor)}{NameOf(property.PropertyType, Nullability.Create(property))} {property.Name}{index} {{{(IsOffered(property.GetMethod) ? " get;" : "")}{set} }}";
        }

        foreach (EventInfo happening in type.GetEvents(Declared).Where(e => IsOffered(e.AddMethod)))
        {
            yield return $"event {NameOf(happening.EventHandlerType!)} {happening.Name}";
        }

        foreach (ConstructorInfo constructor in type.GetConstructors(Declared).Where(c => IsOffered(c) && !IsCompiled(c)))
        {
            yield return $"constructor ({Parameters(constructor.GetParameters())})";
        }

        foreach (MethodInfo method in type.GetMethods(Declared).Where(m => IsOffered(m) && !IsCompiled(m) && (!m.IsSpecialName || m.Name.StartsWith("op_", StringComparison.Ordinal))))
        {
            string arguments = method.IsGenericMethod ? $"<{string.Join(", ", method.GetGenericArguments().Select(a => a.Name))}>" : "";
            string constraints = method.IsGenericMethod ? Constraints(method.GetGenericArguments()) : "";
            yield return $"method {Modifiers(method)}{NameOf(method.ReturnType, Nullability.Create(method.ReturnParameter))} {method.Name}{arguments}({Parameters(method.GetParameters())}){constraints}";
        }
    }

    private static bool IsOffered(MethodBase? method) => method != null && (method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly);

    /// <summary>What the compiler adds to records: comparison, text and copying.</summary>
    private static bool IsCompiled(MethodBase method) => method.IsDefined(typeof(CompilerGeneratedAttribute), false);

    private static bool IsInit(MethodInfo set) => set.ReturnParameter.GetRequiredCustomModifiers().Any(m => m.Name == "IsExternalInit");

    private static bool IsReadOnly(Type type) => type.CustomAttributes.Any(a => a.AttributeType.Name == "IsReadOnlyAttribute");

    private static bool Inherited(Type type, Type contract) => type.BaseType?.GetInterfaces().Contains(contract) == true || type.GetInterfaces().Any(i => i != contract && i.GetInterfaces().Contains(contract));

    private static string Modifiers(FieldInfo field) => field.IsLiteral ? "const " : (field.IsStatic ? "static " : "") + (field.IsInitOnly ? "readonly " : "");

    private static string Modifiers(MethodInfo method)
    {
        string access = method.IsPublic ? "" : "protected ";
        bool inherited = method.GetBaseDefinition() != method;
        string kind = method.DeclaringType!.IsInterface ? "" : method.IsStatic ? "static " : method.IsAbstract ? "abstract " : inherited ? "override " : method.IsVirtual && !method.IsFinal ? "virtual " : "";
        return access + kind;
    }

    private static string Parameters(IEnumerable<ParameterInfo> parameters) => string.Join(", ", parameters.Select(Parameter));

    private static string Parameter(ParameterInfo parameter)
    {
        string passing = parameter.IsOut ? "out " : parameter.IsIn && parameter.ParameterType.IsByRef ? "in " : parameter.ParameterType.IsByRef ? "ref " : "";
        string many = parameter.IsDefined(typeof(ParamArrayAttribute), false) ? "params " : "";
        string value = parameter.HasDefaultValue ? " = " + Literal(parameter.DefaultValue) : "";
        return $"{passing}{many}{NameOf(parameter.ParameterType, Nullability.Create(parameter))} {parameter.Name}{value}";
    }

    private static string Constraints(Type[] arguments)
    {
        var text = new StringBuilder();
        foreach (Type argument in arguments.Where(a => a.IsGenericParameter))
        {
            GenericParameterAttributes kind = argument.GenericParameterAttributes;
            var parts = new List<string>();
            if (kind.HasFlag(GenericParameterAttributes.NotNullableValueTypeConstraint))
            {
                parts.Add("struct");
            }
            else if (kind.HasFlag(GenericParameterAttributes.ReferenceTypeConstraint))
            {
                parts.Add("class");
            }

            parts.AddRange(argument.GetGenericParameterConstraints().Where(c => c != typeof(ValueType)).Select(NameOf).Order(StringComparer.Ordinal));
            text.Append(parts.Count == 0 ? "" : $" where {argument.Name} : {string.Join(", ", parts)}");
        }

        return text.ToString();
    }

    private static string NameOf(Type type, NullabilityInfo nullability)
    {
        Type bare = type.IsByRef ? type.GetElementType()! : type;
        NullabilityState state = nullability.ReadState == NullabilityState.Unknown ? nullability.WriteState : nullability.ReadState;
        return NameOf(bare) + (!bare.IsValueType && state == NullabilityState.Nullable ? "?" : "");
    }

    private static string NameOf(Type type)
    {
        if (type.IsArray)
        {
            return NameOf(type.GetElementType()!) + "[]";
        }

        if (Nullable.GetUnderlyingType(type) is Type value)
        {
            return NameOf(value) + "?";
        }

        string outer = type.IsNested && !type.IsGenericParameter ? NameOf(type.DeclaringType!) + "." : "";
        string name = type.Name.Split('`')[0];
        return outer + (type.IsGenericType && type.Name.Contains('`', StringComparison.Ordinal) ? $"{name}<{string.Join(", ", type.GetGenericArguments().Select(NameOf))}>" : name);
    }

    private static string Literal(object? value) => value switch
    {
        null => "null",
        string text => "\"" + text + "\"",
        double number => number.ToString("R", CultureInfo.InvariantCulture),
        float number => number.ToString("R", CultureInfo.InvariantCulture),
        _ => Convert.ToString(value, CultureInfo.InvariantCulture)!,
    };
}
