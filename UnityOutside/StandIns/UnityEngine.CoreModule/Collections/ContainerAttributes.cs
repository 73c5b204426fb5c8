namespace Unity.Collections.LowLevel.Unsafe;

[AttributeUsage(AttributeTargets.Struct)]
public sealed class NativeContainerAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Struct)]
public sealed class NativeContainerIsReadOnlyAttribute : Attribute { }

/// <summary>May be written in parallel.</summary>
[AttributeUsage(AttributeTargets.Struct)]
public sealed class NativeContainerIsAtomicWriteOnlyAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Struct)]
public sealed class NativeContainerSupportsMinMaxWriteRestrictionAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Struct)]
public sealed class NativeContainerSupportsDeallocateOnJobCompletionAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Method | AttributeTargets.Property)]
public class WriteAccessRequiredAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeDisableUnsafePtrRestrictionAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeDisableContainerSafetyRestrictionAttribute : Attribute { }

[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeSetThreadIndexAttribute : Attribute { }
