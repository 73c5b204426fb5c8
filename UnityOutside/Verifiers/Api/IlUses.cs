namespace UnityOutside.Api;

public sealed record IlUse(MemberReference Member, string Site, TypeDefinition? Within, Code? Code);

public static class IlUses
{
    public static IEnumerable<IlUse> Of(ModuleDefinition module)
    {
        foreach (IlUse use in Attributes(module.Assembly, "assembly", null).Concat(Attributes(module, "module", null)))
            yield return use;
        foreach (TypeDefinition type in module.GetTypes())
        {
            foreach (IlUse use in OfType(type))
                yield return use;
        }
    }

    private static IEnumerable<IlUse> OfType(TypeDefinition type)
    {
        string site = DocId.DefinitionName(type);
        IlUse Named(MemberReference member, string at) => new IlUse(member, at, type, null);

        if (type.BaseType != null)
            yield return Named(type.BaseType, site);
        foreach (InterfaceImplementation implementation in type.Interfaces)
            yield return Named(implementation.InterfaceType, site);
        foreach (IlUse use in Attributes(type, site, type).Concat(Constraints(type, site, type)))
            yield return use;
        foreach (FieldDefinition field in type.Fields)
        {
            yield return Named(field.FieldType, site + "." + field.Name);
            foreach (IlUse use in Attributes(field, site + "." + field.Name, type))
                yield return use;
        }
        foreach (PropertyDefinition property in type.Properties)
        {
            foreach (IlUse use in Attributes(property, site + "." + property.Name, type))
                yield return use;
        }
        foreach (EventDefinition happening in type.Events)
        {
            foreach (IlUse use in Attributes(happening, site + "." + happening.Name, type))
                yield return use;
        }
        foreach (MethodDefinition method in type.Methods)
        {
            foreach (IlUse use in OfMethod(method, type))
                yield return use;
        }
    }

    private static IEnumerable<IlUse> OfMethod(MethodDefinition method, TypeDefinition type)
    {
        string site = DocId.DefinitionName(type) + "." + method.Name;
        IlUse Named(MemberReference member, Code? code = null) => new IlUse(member, site, type, code);

        yield return Named(method.ReturnType);
        foreach (ParameterDefinition parameter in method.Parameters)
        {
            yield return Named(parameter.ParameterType);
            foreach (IlUse use in Attributes(parameter, site, type))
                yield return use;
        }
        foreach (IlUse use in Attributes(method, site, type)
            .Concat(Attributes(method.MethodReturnType, site, type)).Concat(Constraints(method, site, type)))
            yield return use;
        foreach (MethodReference overridden in method.Overrides)
            yield return Named(overridden);
        if (!method.HasBody)
            yield break;
        foreach (VariableDefinition variable in method.Body.Variables)
            yield return Named(variable.VariableType);
        foreach (ExceptionHandler handler in method.Body.ExceptionHandlers.Where(h => h.CatchType != null))
            yield return Named(handler.CatchType);
        foreach (Instruction instruction in method.Body.Instructions)
        {
            switch (instruction.Operand)
            {
                case MemberReference member:
                    yield return Named(member, instruction.OpCode.Code);
                    break;
                case CallSite site2:
                    yield return Named(site2.ReturnType);
                    foreach (ParameterDefinition parameter in site2.Parameters)
                        yield return Named(parameter.ParameterType);
                    break;
            }
        }
    }

    private static IEnumerable<IlUse> Constraints(IGenericParameterProvider provider, string site, TypeDefinition within)
    {
        foreach (GenericParameter parameter in provider.GenericParameters)
        {
            foreach (GenericParameterConstraint constraint in parameter.Constraints)
                yield return new IlUse(constraint.ConstraintType, site, within, null);
        }
    }

    private static IEnumerable<IlUse> Attributes(ICustomAttributeProvider provider, string site, TypeDefinition? within)
    {
        foreach (CustomAttribute attribute in provider.CustomAttributes)
        {
            yield return new IlUse(attribute.Constructor, site, within, Code.Newobj);
            foreach (CustomAttributeNamedArgument named in attribute.Properties)
            {
                // A constructor's return type is void, as a setter's.
                var setter = new MethodReference("set_" + named.Name, attribute.Constructor.ReturnType, attribute.AttributeType)
                { HasThis = true };
                setter.Parameters.Add(new ParameterDefinition(named.Argument.Type));
                yield return new IlUse(setter, site, within, Code.Callvirt);
            }
            foreach (CustomAttributeNamedArgument named in attribute.Fields)
            {
                yield return new IlUse(new FieldReference(named.Name, named.Argument.Type, attribute.AttributeType),
                    site, within, Code.Stfld);
            }
            foreach (TypeReference argument in attribute.ConstructorArguments.Select(a => a.Value).OfType<TypeReference>())
                yield return new IlUse(argument, site, within, null);
        }
    }
}
