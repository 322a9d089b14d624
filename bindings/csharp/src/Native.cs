// The C functions as they are: see the headers, include/contdyn/*.h. Made by generate.py from ../api.json: do not edit.
using System;
using System.Runtime.InteropServices;

namespace Contdyn
{
    internal static unsafe partial class Native
    {
        internal const uint Major = 0, Minor = 2;

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr cd_status_name(int status);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr cd_error_message();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_saved_shape(void* bytes, UIntPtr size, int* outKind, UIntPtr* outFirst,
            UIntPtr* outSecond, UIntPtr* outComponents, int* outPrecision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint cd_runnable_kernels();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr cd_kernels_name(int kernels);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern uint cd_version();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr cd_version_string();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern IntPtr cd_build_info();

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_create(UIntPtr strands, UIntPtr springs, UIntPtr components, int precision,
            void* allocator, IntPtr* outChain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void cd_chain_destroy(IntPtr chain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_shape(ChainHandle chain, UIntPtr* outStrands, UIntPtr* outSprings,
            UIntPtr* outComponents, int* outPrecision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_method(ChainHandle chain, int method);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_method(ChainHandle chain, int* outMethod);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_lambda(ChainHandle chain, double lambda);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_lambda(ChainHandle chain, double* outLambda);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_parallel(ChainHandle chain, void* parallel);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_kernels(ChainHandle chain, int kernels);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_kernels(ChainHandle chain, int* outKernels);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_mass(ChainHandle chain, double mass);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_mass(ChainHandle chain, double* outMass);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_mass_rule(ChainHandle chain, int rule);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_mass_rule(ChainHandle chain, int* outRule);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_stiffness(ChainHandle chain, double stiffness);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_stiffness(ChainHandle chain, double* outStiffness);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_bend(ChainHandle chain, double bend);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_bend(ChainHandle chain, double* outBend);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_drag(ChainHandle chain, double drag);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_drag(ChainHandle chain, double* outDrag);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_stiffness_damping(ChainHandle chain, double seconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_stiffness_damping(ChainHandle chain, double* outSeconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_gravity(ChainHandle chain, double* gravity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_gravity(ChainHandle chain, double* outGravity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_end(ChainHandle chain, int end, int kind);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_end(ChainHandle chain, int end, int* outKind);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_ring(ChainHandle chain, int ring);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_ring(ChainHandle chain, int* outRing);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_sleep(ChainHandle chain, double speed, double seconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_sleep(ChainHandle chain, double* outSpeed, double* outSeconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_awake(ChainHandle chain, UIntPtr* outNodes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_rest_length(ChainHandle chain, double length);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_rest_length(ChainHandle chain, double* outLength);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_rest_angle(ChainHandle chain, double angle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_rest_angle(ChainHandle chain, double* outAngle);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_push(ChainHandle chain, int push);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_push(ChainHandle chain, int* outPush);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_strength(ChainHandle chain, double strength);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_strength(ChainHandle chain, double* outStrength);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_broken(ChainHandle chain, UIntPtr* outSprings);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_reaction(ChainHandle chain, UIntPtr strand, UIntPtr node,
            double* outForce, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_air(ChainHandle chain, double along, double across);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_air(ChainHandle chain, double* outAlong, double* outAcross);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_wind(ChainHandle chain, double* velocity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_wind(ChainHandle chain, double* outVelocity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_tolerance(ChainHandle chain, double tolerance, UIntPtr mostIterations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_tolerance(ChainHandle chain, double* outTolerance,
            UIntPtr* outMostIterations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_convergence(ChainHandle chain, UIntPtr* outIterations,
            double* outResidual);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_colliders(ChainHandle chain, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_colliders(ChainHandle chain, UIntPtr* outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_plane(ChainHandle chain, UIntPtr index, double* point, double* normal,
            UIntPtr count, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_capsule(ChainHandle chain, UIntPtr index, double* first, double* last,
            UIntPtr count, double radius, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_bed(ChainHandle chain, UIntPtr index, double* origin, UIntPtr count,
            UIntPtr columns, UIntPtr rows, double columnSpacing, double rowSpacing, double* heights,
            UIntPtr heightCount, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_bed(ChainHandle chain, UIntPtr index, UIntPtr* outColumns,
            UIntPtr* outRows, double* outHeights, UIntPtr heightCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_callback(ChainHandle chain, UIntPtr index, void* distance,
            double* origin, UIntPtr count, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_remove_collider(ChainHandle chain, UIntPtr index);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_collider_velocity(ChainHandle chain, UIntPtr index, double* velocity,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_collider(ChainHandle chain, UIntPtr index, int* outShape,
            double* outFirst, double* outSecond, double* outVelocity, UIntPtr count, double* outRadius,
            double* outFriction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_loads(ChainHandle chain, int loads);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_loads(ChainHandle chain, int* outLoads);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_collider_load(ChainHandle chain, UIntPtr index, double* outLoad,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_set_thickness(ChainHandle chain, double radius);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_thickness(ChainHandle chain, double* outRadius);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_enable_field(ChainHandle chain, int field);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_disable_field(ChainHandle chain, int field);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_write_f32(ChainHandle chain, int field, UIntPtr firstStrand,
            UIntPtr strands, UIntPtr first, UIntPtr n, float* values, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_write_f64(ChainHandle chain, int field, UIntPtr firstStrand,
            UIntPtr strands, UIntPtr first, UIntPtr n, double* values, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_read_f32(ChainHandle chain, int field, UIntPtr firstStrand,
            UIntPtr strands, UIntPtr first, UIntPtr n, float* outValues, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_read_f64(ChainHandle chain, int field, UIntPtr firstStrand,
            UIntPtr strands, UIntPtr first, UIntPtr n, double* outValues, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_view(ChainHandle chain, int field, IntPtr* outData,
            UIntPtr* outStrandStride, UIntPtr* outNodeStride, UIntPtr* outComponentStride);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_impulse(ChainHandle chain, UIntPtr strand, UIntPtr node, double* impulse,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_teleport(ChainHandle chain, UIntPtr strand, double* rotation,
            double* offset, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_attach(ChainHandle chain, UIntPtr strand, UIntPtr node, double stiffness,
            double damping, double* target, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_detach(ChainHandle chain, UIntPtr strand, UIntPtr node);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_attachment(ChainHandle chain, UIntPtr strand, UIntPtr node,
            double* outStiffness, double* outDamping);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_cut(ChainHandle chain, UIntPtr strand, UIntPtr spring);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_weld(ChainHandle chain, UIntPtr strand, UIntPtr spring);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_step(ChainHandle chain, double dt, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_stable_dt(ChainHandle chain, double* outDt);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_time(ChainHandle chain, double* outTime);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_steps(ChainHandle chain, ulong* outSteps);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_factorizations(ChainHandle chain, ulong* outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_energy(ChainHandle chain, double* outKinetic, double* outElastic,
            double* outGravity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_momentum(ChainHandle chain, double* outMomentum, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_sample(ChainHandle chain, UIntPtr strand, double* at, UIntPtr n,
            int outside, double* outPositions, UIntPtr outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_get_memory(ChainHandle chain, UIntPtr* outBytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_hash(ChainHandle chain, ulong* outHash);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_save_size(ChainHandle chain, UIntPtr* outSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_save(ChainHandle chain, void* buffer, UIntPtr size, UIntPtr* outWritten);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_load(ChainHandle chain, void* bytes, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_copy_state(ChainHandle chain, ChainHandle source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_chain_reset(ChainHandle chain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_create(UIntPtr nu, UIntPtr nv, UIntPtr components, int precision,
            void* allocator, IntPtr* outMembrane);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void cd_membrane_destroy(IntPtr membrane);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_shape(MembraneHandle membrane, UIntPtr* outNu, UIntPtr* outNv,
            UIntPtr* outComponents, int* outPrecision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_method(MembraneHandle membrane, int method);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_method(MembraneHandle membrane, int* outMethod);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_lambda(MembraneHandle membrane, double lambda);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_lambda(MembraneHandle membrane, double* outLambda);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_solver(MembraneHandle membrane, int solver);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_solver(MembraneHandle membrane, int* outSolver);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_solver_taken(MembraneHandle membrane, int* outSolver);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_tolerance(MembraneHandle membrane, double tolerance,
            UIntPtr mostIterations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_tolerance(MembraneHandle membrane, double* outTolerance,
            UIntPtr* outMostIterations);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_convergence(MembraneHandle membrane, UIntPtr* outIterations,
            double* outResidual);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_parallel(MembraneHandle membrane, void* parallel);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_kernels(MembraneHandle membrane, int kernels);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_kernels(MembraneHandle membrane, int* outKernels);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_mass(MembraneHandle membrane, double mass);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_mass(MembraneHandle membrane, double* outMass);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_mass_rule(MembraneHandle membrane, int rule);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_mass_rule(MembraneHandle membrane, int* outRule);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_stiffness(MembraneHandle membrane, double alongU, double alongV);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_stiffness(MembraneHandle membrane, double* outAlongU,
            double* outAlongV);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_bend(MembraneHandle membrane, double bend);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_bend(MembraneHandle membrane, double* outBend);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_drag(MembraneHandle membrane, double drag);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_drag(MembraneHandle membrane, double* outDrag);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_stiffness_damping(MembraneHandle membrane, double seconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_stiffness_damping(MembraneHandle membrane, double* outSeconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_gravity(MembraneHandle membrane, double* gravity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_gravity(MembraneHandle membrane, double* outGravity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_pressure(MembraneHandle membrane, double pressure);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_pressure(MembraneHandle membrane, double* outPressure);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_edge(MembraneHandle membrane, int edge, int kind);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_edge(MembraneHandle membrane, int edge, int* outKind);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_ring(MembraneHandle membrane, int alongU, int alongV);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_ring(MembraneHandle membrane, int* outAlongU, int* outAlongV);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_sleep(MembraneHandle membrane, double speed, double seconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_sleep(MembraneHandle membrane, double* outSpeed, double* outSeconds);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_awake(MembraneHandle membrane, UIntPtr* outNodes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_rest_length(MembraneHandle membrane, double alongU, double alongV);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_rest_length(MembraneHandle membrane, double* outAlongU,
            double* outAlongV);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_shear(MembraneHandle membrane, double stiffness);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_shear(MembraneHandle membrane, double* outStiffness);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_compression(MembraneHandle membrane, double rate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_compression(MembraneHandle membrane, double* outRate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_breaking_strain(MembraneHandle membrane, double strain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_breaking_strain(MembraneHandle membrane, double* outStrain);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_broken(MembraneHandle membrane, UIntPtr* outSprings);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_effort(MembraneHandle membrane, UIntPtr newton, UIntPtr gradient);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_effort(MembraneHandle membrane, UIntPtr* outNewton,
            UIntPtr* outGradient);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_air(MembraneHandle membrane, double along, double across);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_air(MembraneHandle membrane, double* outAlong, double* outAcross);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_wind(MembraneHandle membrane, double* velocity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_wind(MembraneHandle membrane, double* outVelocity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_colliders(MembraneHandle membrane, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_colliders(MembraneHandle membrane, UIntPtr* outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_plane(MembraneHandle membrane, UIntPtr index, double* point,
            double* normal, UIntPtr count, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_capsule(MembraneHandle membrane, UIntPtr index, double* first,
            double* last, UIntPtr count, double radius, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_bed(MembraneHandle membrane, UIntPtr index, double* origin,
            UIntPtr count, UIntPtr columns, UIntPtr rows, double columnSpacing, double rowSpacing, double* heights,
            UIntPtr heightCount, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_bed(MembraneHandle membrane, UIntPtr index, UIntPtr* outColumns,
            UIntPtr* outRows, double* outHeights, UIntPtr heightCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_callback(MembraneHandle membrane, UIntPtr index, void* distance,
            double* origin, UIntPtr count, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_remove_collider(MembraneHandle membrane, UIntPtr index);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_collider_velocity(MembraneHandle membrane, UIntPtr index,
            double* velocity, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_collider(MembraneHandle membrane, UIntPtr index, int* outShape,
            double* outFirst, double* outSecond, double* outVelocity, UIntPtr count, double* outRadius,
            double* outFriction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_loads(MembraneHandle membrane, int loads);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_loads(MembraneHandle membrane, int* outLoads);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_collider_load(MembraneHandle membrane, UIntPtr index,
            double* outLoad, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_set_thickness(MembraneHandle membrane, double distance);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_thickness(MembraneHandle membrane, double* outDistance);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_enable_field(MembraneHandle membrane, int field);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_disable_field(MembraneHandle membrane, int field);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_write_f32(MembraneHandle membrane, int field, UIntPtr firstU,
            UIntPtr firstV, UIntPtr nU, UIntPtr nV, float* values, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_write_f64(MembraneHandle membrane, int field, UIntPtr firstU,
            UIntPtr firstV, UIntPtr nU, UIntPtr nV, double* values, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_read_f32(MembraneHandle membrane, int field, UIntPtr firstU,
            UIntPtr firstV, UIntPtr nU, UIntPtr nV, float* outValues, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_read_f64(MembraneHandle membrane, int field, UIntPtr firstU,
            UIntPtr firstV, UIntPtr nU, UIntPtr nV, double* outValues, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_view(MembraneHandle membrane, int field, IntPtr* outData,
            UIntPtr* outUStride, UIntPtr* outVStride, UIntPtr* outComponentStride);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_impulse(MembraneHandle membrane, double u, double v, double radius,
            double* impulse, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_teleport(MembraneHandle membrane, double* rotation, double* offset,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_attach(MembraneHandle membrane, UIntPtr u, UIntPtr v, double stiffness,
            double damping, double* target, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_detach(MembraneHandle membrane, UIntPtr u, UIntPtr v);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_attachment(MembraneHandle membrane, UIntPtr u, UIntPtr v,
            double* outStiffness, double* outDamping);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_step(MembraneHandle membrane, double dt, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_stable_dt(MembraneHandle membrane, double* outDt);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_time(MembraneHandle membrane, double* outTime);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_steps(MembraneHandle membrane, ulong* outSteps);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_factorizations(MembraneHandle membrane, ulong* outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_energy(MembraneHandle membrane, double* outKinetic,
            double* outElastic, double* outGravity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_momentum(MembraneHandle membrane, double* outMomentum,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_reaction(MembraneHandle membrane, UIntPtr u, UIntPtr v,
            double* outForce, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_volume(MembraneHandle membrane, double* outVolume);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_sample(MembraneHandle membrane, double* at, UIntPtr n, int outside,
            double* outPositions, UIntPtr outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_memory(MembraneHandle membrane, UIntPtr* outBytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_hash(MembraneHandle membrane, ulong* outHash);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_write_vertices(MembraneHandle membrane, void* buffer, UIntPtr size,
            UIntPtr stride, UIntPtr positionOffset, UIntPtr normalOffset);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_get_index_count(MembraneHandle membrane, UIntPtr* outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_write_indices(MembraneHandle membrane, void* buffer, UIntPtr size,
            UIntPtr indexSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_save_size(MembraneHandle membrane, UIntPtr* outSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_save(MembraneHandle membrane, void* buffer, UIntPtr size,
            UIntPtr* outWritten);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_load(MembraneHandle membrane, void* bytes, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_copy_state(MembraneHandle membrane, MembraneHandle source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_membrane_reset(MembraneHandle membrane);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_create(UIntPtr nx, UIntPtr ny, double dx, double dy, int precision,
            void* allocator, IntPtr* outWater);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern void cd_water_destroy(IntPtr water);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_shape(WaterHandle water, UIntPtr* outNx, UIntPtr* outNy, double* outDx,
            double* outDy, int* outPrecision);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_method(WaterHandle water, int method);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_method(WaterHandle water, int* outMethod);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_lambda(WaterHandle water, double lambda);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_lambda(WaterHandle water, double* outLambda);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_momentum(WaterHandle water, int momentum);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_momentum(WaterHandle water, int* outMomentum);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_first(WaterHandle water, int alongY);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_first(WaterHandle water, int* outAlongY);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_parallel(WaterHandle water, void* parallel);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_kernels(WaterHandle water, int kernels);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_kernels(WaterHandle water, int* outKernels);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_gravity(WaterHandle water, double gravity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_gravity(WaterHandle water, double* outGravity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_density(WaterHandle water, double density);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_density(WaterHandle water, double* outDensity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_drag(WaterHandle water, double drag);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_drag(WaterHandle water, double* outDrag);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_manning(WaterHandle water, double manning);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_manning(WaterHandle water, double* outManning);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_side(WaterHandle water, int side, int kind, double value, double rate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_side(WaterHandle water, int side, int* outKind, double* outValue,
            double* outRate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_inflow_depth(WaterHandle water, int side, double depth);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_inflow_depth(WaterHandle water, int side, double* outDepth);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_bed_rule(WaterHandle water, int rule);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_bed_rule(WaterHandle water, int* outRule);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_enable_field(WaterHandle water, int field);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_disable_field(WaterHandle water, int field);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_write_f32(WaterHandle water, int field, UIntPtr firstX, UIntPtr firstY,
            UIntPtr nX, UIntPtr nY, float* values, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_write_f64(WaterHandle water, int field, UIntPtr firstX, UIntPtr firstY,
            UIntPtr nX, UIntPtr nY, double* values, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_read_f32(WaterHandle water, int field, UIntPtr firstX, UIntPtr firstY,
            UIntPtr nX, UIntPtr nY, float* outValues, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_read_f64(WaterHandle water, int field, UIntPtr firstX, UIntPtr firstY,
            UIntPtr nX, UIntPtr nY, double* outValues, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_view(WaterHandle water, int field, IntPtr* outData, UIntPtr* outXStride,
            UIntPtr* outYStride);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_add_volume(WaterHandle water, double x, double y, double radius,
            double volume, double* outAdded);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_add_volume_rectangle(WaterHandle water, UIntPtr firstX, UIntPtr firstY,
            UIntPtr nX, UIntPtr nY, double volume, double* outAdded);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_add_source(WaterHandle water, double x, double y, double radius,
            double rate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_add_source_rectangle(WaterHandle water, UIntPtr firstX, UIntPtr firstY,
            UIntPtr nX, UIntPtr nY, double rate);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_splash(WaterHandle water, double x, double y, double radius, double height);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_impulse(WaterHandle water, double x, double y, double radius,
            double impulseX, double impulseY);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_hulls(WaterHandle water, UIntPtr count, UIntPtr nAlong,
            UIntPtr nAcross);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hulls(WaterHandle water, UIntPtr* outCount, UIntPtr* outNAlong,
            UIntPtr* outNAcross);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_hull(WaterHandle water, UIntPtr index, double mass, double length,
            double width, double* heights, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_disc(WaterHandle water, UIntPtr index, double mass, double radius);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull(WaterHandle water, UIntPtr index, double* outMass,
            double* outLength, double* outWidth, double* outArea, double* outHeights, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_remove_hull(WaterHandle water, UIntPtr index);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_launch_hull(WaterHandle water, UIntPtr index, double x, double y,
            double aheadX, double aheadY);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_hull_pose(WaterHandle water, UIntPtr index, double* pose,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull_pose(WaterHandle water, UIntPtr index, double* outPose,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_hull_velocity(WaterHandle water, UIntPtr index, double* velocity,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull_velocity(WaterHandle water, UIntPtr index, double* outVelocity,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull_floor(WaterHandle water, UIntPtr index, double* outPose,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_hull_force(WaterHandle water, UIntPtr index, double* force,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull_force(WaterHandle water, UIntPtr index, double* outForce,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_hull_drag(WaterHandle water, UIntPtr index, double along,
            double across, double friction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull_drag(WaterHandle water, UIntPtr index, double* outAlong,
            double* outAcross, double* outFriction);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull_load(WaterHandle water, UIntPtr index, double* outLoad,
            UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_hull_energy(WaterHandle water, double* outKinetic,
            double* outPotential);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_sample_heads(WaterHandle water, double* at, UIntPtr n, int outside,
            double* outHeads);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_step(WaterHandle water, double dt, UIntPtr count);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_stable_dt(WaterHandle water, double* outDt);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_time(WaterHandle water, double* outTime);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_steps(WaterHandle water, ulong* outSteps);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_factorizations(WaterHandle water, ulong* outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_limited(WaterHandle water, ulong* outCells, double* outVolume);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_set_sleep(WaterHandle water, double height);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_sleep(WaterHandle water, double* outHeight);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_awake(WaterHandle water, UIntPtr* outCells);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_volume(WaterHandle water, double* outVolume);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_account(WaterHandle water, double* outInitial, double* outIn,
            double* outOut, double* outError);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_restart_account(WaterHandle water);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_energy(WaterHandle water, double* outKinetic, double* outPotential);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_wet_area(WaterHandle water, double* outArea);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_courant(WaterHandle water, double dt, double* outCourant);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_sample(WaterHandle water, double* at, UIntPtr n, int outside,
            double* outSurface, double* outDepth, double* outNormal, double* outVelocity);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_memory(WaterHandle water, UIntPtr* outBytes);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_hash(WaterHandle water, ulong* outHash);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_write_vertices(WaterHandle water, void* buffer, UIntPtr size,
            UIntPtr stride, UIntPtr positionOffset, UIntPtr normalOffset, UIntPtr depthOffset);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_get_index_count(WaterHandle water, int skipDry, UIntPtr* outCount);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_write_indices(WaterHandle water, int skipDry, void* buffer, UIntPtr size,
            UIntPtr indexSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_save_size(WaterHandle water, UIntPtr* outSize);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_save(WaterHandle water, void* buffer, UIntPtr size, UIntPtr* outWritten);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_load(WaterHandle water, void* bytes, UIntPtr size);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_copy_state(WaterHandle water, WaterHandle source);

        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int cd_water_reset(WaterHandle water);
    }

    internal sealed class ChainHandle : ObjectHandle
    {
        internal ChainHandle(IntPtr handle) : base(handle) { }

        protected override bool ReleaseHandle()
        {
            Native.cd_chain_destroy(handle);
            return true;
        }
    }

    internal sealed class MembraneHandle : ObjectHandle
    {
        internal MembraneHandle(IntPtr handle) : base(handle) { }

        protected override bool ReleaseHandle()
        {
            Native.cd_membrane_destroy(handle);
            return true;
        }
    }

    internal sealed class WaterHandle : ObjectHandle
    {
        internal WaterHandle(IntPtr handle) : base(handle) { }

        protected override bool ReleaseHandle()
        {
            Native.cd_water_destroy(handle);
            return true;
        }
    }
}
