using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;

namespace CreatureGen.Reference;

/// <summary>The public types of assemblies as Markdown, a page for each namespace.</summary>
internal static class ReferencePages
{
    private static readonly Dictionary<string, string> keywords = new()
    {
        ["System.Boolean"] = "bool", ["System.Byte"] = "byte", ["System.Int16"] = "short", ["System.UInt16"] = "ushort", ["System.Int32"] = "int", ["System.UInt32"] = "uint", ["System.Int64"] = "long",
        ["System.UInt64"] = "ulong", ["System.Single"] = "float", ["System.Double"] = "double", ["System.String"] = "string", ["System.Object"] = "object", ["System.Void"] = "void",
    };

    /// <summary>Writes the pages and an index.</summary>
    /// <returns>How many there are.</returns>
    public static int Write(string folder, IReadOnlyList<(Assembly Assembly, string Xml)> libraries)
    {
        Directory.CreateDirectory(folder);
        Dictionary<string, XElement> notes = libraries.SelectMany(library => XDocument.Load(library.Xml).Descendants("member")).ToDictionary(member => member.Attribute("name")!.Value);
        IGrouping<string, Type>[] spaces = libraries.SelectMany(library => OpenMembers.TypesOf(library.Assembly)).GroupBy(type => type.Namespace!).OrderBy(space => space.Key, StringComparer.Ordinal).ToArray();
        var index = new StringBuilder("# The API, namespace by namespace\n\nMade from the XML comments of the libraries. [How to use it](../using-it.md) · [which namespace is for what](../architecture.md#the-front-door)\n\n| namespace | types |\n| --- | --- |\n");
        foreach (IGrouping<string, Type> space in spaces)
        {
            index.Append(((string)$"| [{space.Key}]({space.Key}.md) | {string.Join(", ", space.Select(Name))} |\n").Replace("<", "\\<", StringComparison.Ordinal));
            File.WriteAllText(Path.Combine(folder, space.Key + ".md"), Page(space, notes));
        }

        File.WriteAllText(Path.Combine(folder, "index.md"), index.ToString());
        return spaces.Length + 1;
    }

    private static string Page(IGrouping<string, Type> space, Dictionary<string, XElement> notes)
    {
        var page = new StringBuilder($"# {space.Key}\n\n[All namespaces](index.md)\n");
        foreach (Type type in space)
        {
            XElement? note = notes.GetValueOrDefault(DocumentationId.Of(type));
            page.Append(CultureInfo.InvariantCulture, $"\n## {Name(type).Replace("<", "\\<", StringComparison.Ordinal)}\n`{Kind(type)}` {Prose(note?.Element("summary"))}\n");
            Paragraph(page, note?.Element("remarks"));
            (string Signature, string Meaning)[] rows = Rows(type, notes).ToArray();
            if (rows.Length > 0)
            {
                page.Append("\n| member | what it is |\n| --- | --- |\n");
                foreach ((string signature, string meaning) in rows)
                {
                    page.Append(CultureInfo.InvariantCulture, $"| `{signature.Replace("|", "\\|", StringComparison.Ordinal)}` | {meaning.Replace("|", "\\|", StringComparison.Ordinal)} |\n");
                }
            }
        }

        return page.ToString();
    }

    private static IEnumerable<(string Signature, string Meaning)> Rows(Type type, Dictionary<string, XElement> notes)
    {
        foreach (MemberInfo member in OpenMembers.Of(type).OrderBy(member => member is ConstructorInfo ? 0 : member is FieldInfo ? 1 : member is PropertyInfo ? 2 : 3).ThenBy(member => type.IsEnum ? 0 : 1))
        {
            // Parameters of a record are documented with the record, what the compiler adds not at all.
            XElement? note = notes.GetValueOrDefault(DocumentationId.Of(member));
            XElement? summary = note?.Element("summary")
                ?? (member is PropertyInfo ? notes.GetValueOrDefault(DocumentationId.Of(type))?.Elements("param").FirstOrDefault(parameter => parameter.Attribute("name")!.Value == member.Name) : null);
            if (summary != null)
            {
                string details = string.Concat((note?.Elements("param") ?? []).Select(parameter => $" `{parameter.Attribute("name")!.Value}`: {Prose(parameter)}"))
                    + (note?.Element("returns") is XElement returns ? " Gives: " + Prose(returns) : "")
                    + string.Concat((note?.Elements("exception") ?? []).Select(problem => $" Throws {Short(problem.Attribute("cref")!.Value)}: {Prose(problem)}"));
                yield return (Signature(member), Prose(summary) + details);
            }
        }
    }

    private static string Kind(Type type) => type.IsEnum ? "enum" : type.IsInterface ? "interface" : type.IsValueType ? "struct" : type.IsAbstract && type.IsSealed ? "static class" : type.IsSealed ? "sealed class" : "class";

    private static string Signature(MemberInfo member) => member switch
    {
        FieldInfo { DeclaringType.IsEnum: true } value => value.Name,
        FieldInfo field => $"{Name(field.FieldType)} {field.Name}",
        PropertyInfo property => $"{Name(property.PropertyType)} {(property.GetIndexParameters() is { Length: > 0 } keys ? $"this[{List(keys)}]" : property.Name)}",
        ConstructorInfo constructor => $"new {Name(constructor.DeclaringType!)}({List(constructor.GetParameters())})",
        MethodInfo method => $"{(method.IsStatic ? "static " : "")}{Name(method.ReturnType)} {method.Name}{(method.IsGenericMethod ? $"<{string.Join(", ", method.GetGenericArguments().Select(Name))}>" : "")}({List(method.GetParameters())})",
        EventInfo raised => $"event {Name(raised.EventHandlerType!)} {raised.Name}",
        _ => member.Name,
    };

    private static string List(ParameterInfo[] parameters) => string.Join(", ", parameters.Select(parameter => (parameter.IsOut ? "out " : parameter.ParameterType.IsByRef ? parameter.IsIn ? "in " : "ref " : "") + Name(parameter.ParameterType) + " " + parameter.Name));

    private static string Name(Type type)
    {
        if (type.IsByRef)
        {
            return Name(type.GetElementType()!);
        }

        if (type.IsArray)
        {
            return Name(type.GetElementType()!) + "[" + new string(',', type.GetArrayRank() - 1) + "]";
        }

        if (Nullable.GetUnderlyingType(type) is Type value)
        {
            return Name(value) + "?";
        }

        string name = (type.IsNested && !type.IsGenericParameter ? Name(type.DeclaringType!) + "." : "") + type.Name.Split('`')[0];
        return keywords.TryGetValue(type.FullName ?? "", out string? keyword) ? keyword : type.IsGenericType ? $"{name}<{string.Join(", ", type.GetGenericArguments().Select(Name))}>" : name;
    }

    private static void Paragraph(StringBuilder page, XElement? note)
    {
        if (note != null)
        {
            page.Append(CultureInfo.InvariantCulture, $"\n{Prose(note)}\n");
        }
    }

    /// <summary>The words of a note, with code and names of types in backticks.</summary>
    private static string Prose(XElement? note)
    {
        if (note is null)
        {
            return "";
        }

        string text = string.Concat(note.Nodes().Select(node => node switch
        {
            XText words => words.Value.Replace("<", "\\<", StringComparison.Ordinal),
            XElement { Name.LocalName: "see" or "seealso" } see => "`" + (see.Attribute("cref")?.Value is string name ? Short(name) : see.Attribute("langword")?.Value) + "`",
            XElement { Name.LocalName: "paramref" or "typeparamref" } parameter => "`" + parameter.Attribute("name")!.Value + "`",
            XElement { Name.LocalName: "c" or "code" } code => "`" + code.Value + "`",
            XElement other => Prose(other),
            _ => "",
        }));
        return Regex.Replace(text, @"\s+", " ").Trim();
    }

    private static string Short(string id)
    {
        string name = id[2..].Split('(')[0];
        string[] parts = name.Split('.');
        string last = parts[^1] == "#ctor" ? "new" : parts[^1];
        return (id[0] == 'T' || parts.Length < 2 ? last : parts[^2] + "." + last).Split('`')[0];
    }
}
